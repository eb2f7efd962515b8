// Meshes a closed box through the installed package: 0 where the mesh is closed, layered and whole.
#include <advlayers/mesher.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <utility>

namespace {

template <class Elements>
void count_sides(const Elements& elements, std::map<std::pair<int, int>, int>& uses) {
  for (const auto& element : elements) {
    for (std::size_t k = 0; k < element.size(); ++k) {
      ++uses[std::minmax(element[k], element[(k + 1) % element.size()])];
    }
  }
}

int mesh(const char* path) {
  advlayers::RunContext context;
  advlayers::set_reader_program(READER);
  const advlayers::Model model = advlayers::read_file(context, path);
  advlayers::Settings settings;
  settings.size = 1.0;
  settings.first_height = 0.1;
  advlayers::Mesher mesher(context, model, settings);
  int layers = 0;
  while (const auto layer = mesher.next()) layers = std::max(layers, layer->layer);
  const advlayers::MeshResult result = mesher.result();
  std::map<std::pair<int, int>, int> uses;
  count_sides(result.quads, uses);
  count_sides(result.triangles, uses);
  const bool closed =
      std::all_of(uses.begin(), uses.end(), [](const auto& side) { return side.second == 2; });
  std::printf("%zu faces, %d layers, %zu quads, %zu triangles, %s\n", model.faces().size(), layers,
              result.quads.size(), result.triangles.size(), closed ? "closed" : "open");
  const bool told = context.progress().stage == advlayers::RunStage::kCore;
  return closed && told && layers > 1 && !result.quads.empty() && result.figures.inverted == 0 ? 0
                                                                                               : 1;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: mesh_a_box FILE\n");
    return 2;
  }
  try {
    return mesh(words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mesh_a_box: %s\n", error.what());
    return 2;
  }
}
