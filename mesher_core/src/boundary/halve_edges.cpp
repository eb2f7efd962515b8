#include "boundary/halve_edges.h"

#include <map>
#include <utility>

namespace advlayers {
namespace {

class Halver {
 public:
  Halver(const RunContext& context, Evaluator& evaluator, Discretization& boundary)
      : context_(context), evaluator_(evaluator), boundary_(boundary) {}

  // Every segment, or only those that edges halved before have in common with it.
  void halve(EdgeId edge, bool all) {
    const EdgeNodes& coarse = boundary_.edges[edge.index()];
    EdgeNodes fine;
    for (std::size_t k = 0; k < coarse.nodes.size(); ++k) {
      context_.check();
      if (k > 0) halve_segment(edge, coarse, k, all, fine);
      fine.nodes.push_back(coarse.nodes[k]);
      fine.params.push_back(coarse.params[k]);
    }
    boundary_.edges[edge.index()] = std::move(fine);
  }

 private:
  void halve_segment(EdgeId edge, const EdgeNodes& coarse, std::size_t k, bool all,
                     EdgeNodes& fine) {
    const std::pair<NodeId, NodeId> ends = std::minmax(coarse.nodes[k - 1], coarse.nodes[k]);
    const auto known = middles_.find(ends);
    if (known == middles_.end() && !all) return;
    const double t0 = coarse.params[k - 1], t1 = coarse.params[k];
    const double half = 0.5 * evaluator_.edge_length(edge, t0, t1);
    const double t = evaluator_.edge_parameter(edge, t0, half);
    fine.params.push_back(t);
    if (known != middles_.end()) {
      fine.nodes.push_back(known->second);
      return;
    }
    fine.nodes.emplace_back(boundary_.nodes.size());
    boundary_.nodes.push_back({evaluator_.edge_point(edge, t), VertexId(), edge, t});
    middles_.emplace(ends, fine.nodes.back());
  }

  const RunContext& context_;
  Evaluator& evaluator_;
  Discretization& boundary_;
  std::map<std::pair<NodeId, NodeId>, NodeId> middles_;  // of segments, by their ends
};

}  // namespace

void halve_edges(const RunContext& context, Evaluator& evaluator, const std::vector<EdgeId>& edges,
                 Discretization& boundary) {
  if (edges.empty()) return;
  Halver halver(context, evaluator, boundary);
  std::vector<char> halved(boundary.edges.size(), 0);
  for (const EdgeId edge : edges) {
    halver.halve(edge, true);
    halved[edge.index()] = 1;
  }
  for (std::size_t e = 0; e < halved.size(); ++e) {
    if (!halved[e]) halver.halve(EdgeId(e), false);
  }
}

}  // namespace advlayers
