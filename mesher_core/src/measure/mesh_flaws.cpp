#include "measure/mesh_flaws.h"

#include <algorithm>
#include <cmath>

#include "measure/element_measures.h"

namespace advlayers {
namespace {

// Below this part of its longest side squared, an element's area is rounding.
constexpr double kFlat = 1e-12;

void judge_element(const SurfaceMesh& mesh, FaceH f, MeshFlaws& flaws) {
  const ElementCorners element = corners_of(mesh, f);
  double longest2 = 0.0;
  for (int k = 0; k < element.count; ++k) {
    longest2 = std::max(longest2, (element.next(k) - element.at[std::size_t(k)]).squaredNorm());
  }
  if (area_vector(element).norm() <= kFlat * longest2) {
    flaws.flat.push_back(f);
    return;
  }
  const auto angles = interior_angles(element);
  if (*std::min_element(angles.begin(), angles.begin() + element.count) < kNeedle) {
    flaws.needles.push_back(f);
  }
}

// Along a line that no plane of symmetry is square to: what is near is near along it, too.
double place_of(const Vec3& p) { return p.dot(Vec3(0.5477225575, 0.6324555320, 0.5477225575)); }

std::vector<VertexH> coincident_vertices(const RunContext& context, const SurfaceMesh& mesh,
                                         double tolerance) {
  struct Placed {
    double place;
    VertexH v;
  };
  std::vector<Placed> placed;
  placed.reserve(mesh.vertex_capacity());
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (mesh.alive(v)) placed.push_back({place_of(mesh.position(v)), v});
  }
  std::sort(placed.begin(), placed.end(), [&context](const Placed& a, const Placed& b) {
    context.check();
    return a.place < b.place;
  });
  std::vector<VertexH> found;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    context.check();
    const VertexH v = placed[i].v;
    for (std::size_t j = i + 1; j < placed.size() && placed[j].place - placed[i].place <= tolerance;
         ++j) {
      const VertexH w = placed[j].v;
      if ((mesh.position(v) - mesh.position(w)).norm() > tolerance) continue;
      if (mesh.data(v).node.valid() && mesh.data(w).node.valid()) continue;
      found.push_back(std::max(v, w));
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace

MeshFlaws find_mesh_flaws(const RunContext& context, const SurfaceMesh& mesh, double tolerance) {
  MeshFlaws flaws;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    if (mesh.alive(FaceH(i))) judge_element(mesh, FaceH(i), flaws);
  }
  flaws.coincident = coincident_vertices(context, mesh, tolerance);
  return flaws;
}

}  // namespace advlayers
