#include "core/core_splits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "measure/bend_middle.h"
#include "measure/core_region.h"
#include "measure/element_measures.h"

namespace advlayers {
namespace {

constexpr double kBentCosine = 0.8480480962;  // of 32 degrees
// A bend sharper than the surface's own kinks would be split for ever.
constexpr int kMostHalvings = 5;
// A triangle that a split makes may not be worse than this, nor than the one it replaces.
constexpr double kLeastSine = 0.17;

// The sine of the smallest angle against the three normals' mean.
double shape_of(const VertexData& a, const VertexData& b, const VertexData& c) {
  return min_angle_sine(a.point.xyz, b.point.xyz, c.point.xyz, a.normal + b.normal + c.normal);
}

bool split_helps(const SurfaceMesh& mesh, HalfedgeH h, const VertexData& middle) {
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    const VertexData& a = mesh.data(mesh.from(side));
    const VertexData& b = mesh.data(mesh.to(side));
    const VertexData& c = mesh.data(mesh.to(mesh.next(side)));
    const double least = std::min(kLeastSine, shape_of(a, b, c));
    if (shape_of(a, middle, c) < least || shape_of(middle, b, c) < least) return false;
  }
  return true;
}

}  // namespace

int split_bent_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface) {
  struct Bent {
    HalfedgeH edge;
    int halvings;
  };
  std::vector<Bent> waiting;
  const auto enlist = [&](HalfedgeH h, int halvings) {
    if (halvings > kMostHalvings || !is_core_edge(mesh, h)) return;
    if (bend_cosine(mesh, h) < kBentCosine) waiting.push_back({h, halvings});
  };
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) enlist(HalfedgeH(i), 0);
  int splits = 0;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    context.check();
    const auto [h, halvings] = waiting[i];
    if (mesh.split_edge_veto(h) != Veto::kNone) continue;
    VertexData middle;
    if (!find_bend_middle(mesh, surface, h, middle)) continue;
    if (!split_helps(mesh, h, middle)) continue;
    const VertexH v = mesh.split_edge(h, middle);
    ++splits;
    for (const HalfedgeH spoke : mesh.around(v)) {
      enlist(spoke, halvings + 1);
    }
  }
  return splits;
}

}  // namespace advlayers
