#include "layers/isotropy.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kMostLayers = 1e6;       // as good as never
constexpr double kLeastLogGrowth = 1e-6;  // a growth below makes a height no nearer to it

// Layers until the height reaches the length, if the length stays.
double layers_needed(const FrontNode& node, const NodeShape& shape) {
  if (node.growth.height >= shape.length()) return 0.0;
  const double log_growth = std::log(node.growth.ratio);
  if (log_growth < kLeastLogGrowth) return kMostLayers;
  return std::min(kMostLayers,
                  std::ceil(std::log(shape.length() / node.growth.height) / log_growth - 1e-9));
}

}  // namespace

std::vector<char> isotropic_nodes(const Front& front, const std::vector<NodeShape>& shapes) {
  const std::size_t count = front.nodes().size();
  std::vector<double> needed(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const FrontNode& node = front.nodes()[i];
    if (node.active && (node.prev >= 0 || node.next >= 0))
      needed[i] = layers_needed(node, shapes[i]);
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
