// Meshes one shape again and again, each time without one of the method's steps.
//
//     ablation FILE.brep SIZE FIRST_HEIGHT GROWTH
//
// Prints a line of JSON for each: which step was left out (empty: none), elements, quads, angles in
// 45-135 and below 20 degrees, inverted elements, and processor seconds of layers and core.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "boundary/discretization.h"
#include "core/fill_core.h"
#include "geometry/model.h"
#include "layers/patch_layers.h"
#include "measure/core_region.h"
#include "mend/inversion.h"
#include "mesher/figures.h"
#include "mesher/patch_plan.h"
#include "quads/recombine.h"
#include "triangulate/triangulate.h"

namespace {

using namespace advlayers;

struct Variant {
  const char* without;
  bool LayerSteps::*layer_step = nullptr;
  bool RecombineSteps::*core_step = nullptr;
};

// All steps, then each of them left out.
std::vector<Variant> variants() {
  std::vector<Variant> all{{""}};
  for (const OptionalStep& step : kOptionalSteps) all.push_back({step.name, step.member});
  const std::vector<Variant> of_core{
      {"triangle walks", nullptr, &RecombineSteps::walks},
      {"triangle pairs", nullptr, &RecombineSteps::pairs},
      {"pentagons cut anew", nullptr, &RecombineSteps::pentagons},
      {"smoothing of the core", nullptr, &RecombineSteps::smoothing},
  };
  all.insert(all.end(), of_core.begin(), of_core.end());
  return all;
}

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Result {
  FigureCounts counts;
  double seconds = 0.0;
};

void mesh_patch(const RunContext& context, const Model& model, const Settings& settings,
                const Discretization& boundary, const std::vector<FaceId>& faces,
                const LayerSteps& layer_steps, const RecombineSteps& core_steps, Result& result) {
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, faces, settings.feature_angle);
  const WallPlan walls = plan_walls(evaluator, settings, faces);
  SurfaceMesh mesh = triangulate(context, surface, evaluator, boundary, settings).mesh;
  const double start = processor_seconds();
  {
    PatchLayers layers(context, PatchId(0), mesh, surface, walls, layer_steps);
    while (layers.advance()) {
    }
  }
  thaw_core_edges(mesh);
  return_to_core(mesh);
  fill_core(context, mesh, surface, evaluator, settings);
  recombine(context, mesh, surface, LayerCells::kTraded, core_steps);
  mend_inverted(context, mesh, surface);
  return_to_core(mesh);
  result.seconds += processor_seconds() - start;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    result.counts.add(corners_of(mesh, f), mesh.data(f).layer);
    if (is_inverted(mesh, f, surface)) result.counts.add_inverted();
  }
}

void run(const Model& model, const Settings& settings, const Variant& variant) {
  LayerSteps layer_steps;
  RecombineSteps core_steps;
  if (variant.layer_step != nullptr) layer_steps.*variant.layer_step = false;
  if (variant.core_step != nullptr) core_steps.*variant.core_step = false;
  const RunContext context;
  Evaluator evaluator(model);
  const Discretization boundary = discretize(context, evaluator, settings);
  Result result;
  for (const std::vector<FaceId>& faces : group_faces(model, settings)) {
    mesh_patch(context, model, settings, boundary, faces, layer_steps, core_steps, result);
  }
  const Figures figures = result.counts.figures(0);
  std::printf(
      "{\"without\": \"%s\", \"quads\": %d, \"triangles\": %d, \"angles\": %.4f, \"below_20\": "
      "%.4f, \"inverted\": %d, \"seconds\": %.4f}\n",
      variant.without, figures.quads, figures.triangles, figures.angles_45_135_percent,
      figures.angles_below_20_percent, figures.inverted, result.seconds);
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) {
    std::fprintf(stderr, "usage: ablation FILE.brep SIZE FIRST_HEIGHT GROWTH\n");
    return 1;
  }
  try {
    std::ifstream file(words[1]);
    const Model model = read_brep(
        RunContext(), RunContext(),
        std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()));
    Settings settings;
    settings.size = std::atof(words[2]);
    settings.first_height = std::atof(words[3]);
    settings.growth = std::atof(words[4]);
    for (const Variant& variant : variants()) run(model, settings, variant);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "ablation: %s\n", error.what());
    return 1;
  }
  return 0;
}
