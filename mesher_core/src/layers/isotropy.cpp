#include "layers/isotropy.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kMostLayers = 1e6;       // as good as never
constexpr double kLeastLogGrowth = 1e-6;  // a growth below makes a height no nearer to it
// In local sizes: a front that widens stops before its edges are longer, unless the wall's are.
constexpr double kWidest = 1.3;

// The longer edge of the wall at a vertex of it [mm].
double wall_edge(const SurfaceMesh& mesh, VertexH root) {
  const HalfedgeH out = mesh.outgoing(root);
  const auto length = [&](VertexH v) { return (mesh.position(v) - mesh.position(root)).norm(); };
  return std::max(length(mesh.to(out)), length(mesh.from(mesh.prev(out))));
}

// Layers until the height reaches the least of edge length and size, if those stay.
double layers_needed(const LayerState& state, const FrontNode& node, const NodeShape& shape) {
  double length = shape.length();
  if (state.local_size) {
    const double size = state.local_size(state.mesh.data(node.vertex).point);
    const double widest = std::max(kWidest * size, wall_edge(state.mesh, node.root));
    if (std::max(shape.length_next, shape.length_prev) > widest) return 0.0;
    length = std::min(length, size);
  }
  if (node.growth.height >= length) return 0.0;
  const double log_growth = std::log(node.growth.ratio);
  if (log_growth < kLeastLogGrowth) return kMostLayers;
  return std::min(kMostLayers,
                  std::ceil(std::log(length / node.growth.height) / log_growth - 1e-9));
}

}  // namespace

std::vector<char> isotropic_nodes(const LayerState& state, const std::vector<NodeShape>& shapes) {
  const Front& front = state.front;
  const std::size_t count = front.nodes().size();
  std::vector<double> needed(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const FrontNode& node = front.nodes()[i];
    if (node.active && (node.prev >= 0 || node.next >= 0))
      needed[i] = layers_needed(state, node, shapes[i]);
  }
  // Each node's need, less one for each edge, reaches along the front in both directions.
  const auto spread = [&](int FrontNode::*onward) {
    for (std::size_t i = 0; i < count; ++i) {
      double need = needed[i] - 1.0;
      for (int k = front.nodes()[i].*onward; k >= 0 && need > needed[static_cast<std::size_t>(k)];
           k = front[k].*onward, need -= 1.0) {
        needed[static_cast<std::size_t>(k)] = need;
      }
    }
  };
  spread(&FrontNode::next);
  spread(&FrontNode::prev);
  std::vector<char> isotropic(count, 0);
  for (std::size_t i = 0; i < count; ++i) isotropic[i] = needed[i] <= 0.0;
  return isotropic;
}

}  // namespace advlayers
