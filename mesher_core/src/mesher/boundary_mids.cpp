#include "mesher/boundary_mids.h"

#include <algorithm>
#include <tuple>

namespace advlayers {

bool BoundaryMids::Key::operator<(const Key& o) const {
  return std::tie(edge, low, high) < std::tie(o.edge, o.low, o.high);
}

BoundaryMids::BoundaryMids(Evaluator& evaluator, const Discretization& boundary) {
  for (std::size_t e = 0; e < boundary.edges.size(); ++e) {
    const EdgeNodes& cut = boundary.edges[e];
    const EdgeId edge(e);
    for (std::size_t k = 1; k < cut.nodes.size(); ++k) {
      BoundaryMid mid;
      mid.edge = edge;
      mid.from = cut.nodes[k - 1];
      mid.to = cut.nodes[k];
      const double length = evaluator.edge_length(edge, cut.params[k - 1], cut.params[k]);
      const double t = evaluator.edge_parameter(edge, cut.params[k - 1], 0.5 * length);
      mid.curve = evaluator.edge_point(edge, t);
      mid.chord = 0.5 * (boundary.nodes[mid.from.index()].xyz + boundary.nodes[mid.to.index()].xyz);
      const auto [low, high] = std::minmax(mid.from, mid.to);
      keys_.push_back({edge, low, high, static_cast<int>(mids_.size())});
      mids_.push_back(mid);
    }
  }
  std::sort(keys_.begin(), keys_.end());
}

int BoundaryMids::find(EdgeId edge, NodeId a, NodeId b) const {
  const auto [low, high] = std::minmax(a, b);
  const Key wanted{edge, low, high, -1};
  const auto found = std::lower_bound(keys_.begin(), keys_.end(), wanted);
  return found != keys_.end() && !(wanted < *found) ? found->index : -1;
}

}  // namespace advlayers
