#include "layers/make_way.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kHeights = 2.0;     // c of eq. 1
constexpr double kInLayer = 1.5;     // heights within which a vertex must go
constexpr int kMostPerVertex = 200;  // removals at one front vertex and layer

// The nearest core vertex joined to `v` within `reach`, those in `refused` apart.
VertexH nearest_core(const SurfaceMesh& mesh, VertexH v, double reach,
                     const std::vector<VertexH>& refused, double& distance) {
  VertexH nearest;
  distance = reach;
  for (const HalfedgeH h : mesh.around(v)) {
    const VertexH w = mesh.to(h);
    if (is_core_vertex(mesh, w) && std::find(refused.begin(), refused.end(), w) == refused.end()) {
      const double d = (mesh.position(w) - mesh.position(v)).norm();
      if (d < distance) {
        distance = d;
        nearest = w;
      }
    }
  }
  return nearest;
}

void clear_about(LayerState& state, const FrontNode& node, double length) {
  SurfaceMesh& mesh = state.mesh;
  const double height = std::min(node.growth.height, state.max_height);
  const double reach = std::max(length / std::sqrt(2.0), kHeights * height);
  std::vector<VertexH> refused;
  for (int k = 0; k < kMostPerVertex; ++k) {
    double distance = 0.0;
    const VertexH w = nearest_core(mesh, node.vertex, reach, refused, distance);
    if (!w.valid()) return;
    const Removal removal = distance < kInLayer * height ? Removal::kForced : Removal::kGuarded;
    if (!remove_core_vertex(mesh, w, removal, state.limits, state.report.vetoes)) {
      refused.push_back(w);
    }
  }
}

}  // namespace

void make_way(LayerState& state) {
  const Front& front = state.front;
  for (int i = 0; i < front.size(); ++i) {
    const FrontNode& node = front[i];
    if (!node.active) continue;
    state.context.check();
    double length = 0.0;
    for (const int k : {node.prev, node.next}) {
      if (k < 0) continue;
      length = std::max(
          length, (state.mesh.position(front[k].vertex) - state.mesh.position(node.vertex)).norm());
    }
    clear_about(state, node, length);
  }
  state.swaps.run(state.limits, state.report.vetoes);
}

}  // namespace advlayers
