#include "boundary/halve_edges.h"

#include <utility>

namespace advlayers {

void halve_edges(Evaluator& evaluator, const std::vector<EdgeId>& edges, Discretization& boundary) {
  for (const EdgeId edge : edges) {
    const EdgeNodes coarse = std::move(boundary.edges[edge.index()]);
    EdgeNodes fine;
    for (std::size_t k = 0; k < coarse.nodes.size(); ++k) {
      if (k > 0) {
        const double t0 = coarse.params[k - 1], t1 = coarse.params[k];
        const double half = 0.5 * evaluator.edge_length(edge, t0, t1);
        const double t = evaluator.edge_parameter(edge, t0, half);
        fine.nodes.emplace_back(boundary.nodes.size());
        fine.params.push_back(t);
        boundary.nodes.push_back({evaluator.edge_point(edge, t), VertexId(), edge, t});
      }
      fine.nodes.push_back(coarse.nodes[k]);
      fine.params.push_back(coarse.params[k]);
    }
    boundary.edges[edge.index()] = std::move(fine);
  }
}

}  // namespace advlayers
