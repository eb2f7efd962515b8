#include "boundary/periodic_cuts.h"

#include <algorithm>

namespace advlayers {
namespace {

constexpr int kNewtonSteps = 3;  // from a parameter that is right to some digits

// The parameter of the edge's point next to p, from one nearby.
double parameter_at(Evaluator& evaluator, EdgeId edge, double t, const Vec3& p) {
  const Edge& shape = evaluator.model().edge(edge);
  for (int k = 0; k < kNewtonSteps; ++k) {
    const Vec3 tangent = evaluator.edge_tangent(edge, t);
    const double speed2 = tangent.squaredNorm();
    if (!(speed2 > 0.0)) return t;
    t += (p - evaluator.edge_point(edge, t)).dot(tangent) / speed2;
    t = std::clamp(t, shape.first, shape.last);
  }
  return t;
}

std::vector<double> shares_of(const EdgeSpacing& spacing, bool reversed) {
  std::vector<double> shares;
  for (const double cut : spacing.cuts()) shares.push_back(cut / spacing.length());
  if (!reversed) return shares;
  std::reverse(shares.begin(), shares.end());
  for (double& share : shares) share = 1.0 - share;
  return shares;
}

}  // namespace

void cut_alike(const RunContext& context, const std::vector<EdgePair>& pairs,
               Stretches& stretches) {
  for (const EdgePair& pair : pairs) {
    context.check();
    const std::vector<std::size_t>&given = stretches.of(pair.given),
          &found = stretches.of(pair.found);
    if (given.size() != found.size()) continue;
    for (std::size_t k = 0; k < given.size(); ++k) {
      EdgeSpacing& here = stretches[given[k]].spacing;
      EdgeSpacing& there = stretches[found[pair.reversed ? found.size() - 1 - k : k]].spacing;
      while (here.count() < there.count() && here.can_lengthen()) here.lengthen();
      there.cut_at(shares_of(here, pair.reversed));
    }
  }
}

std::vector<EdgePair> place_alike(Evaluator& evaluator, const std::vector<EdgePair>& pairs,
                                  Discretization& boundary) {
  std::vector<EdgePair> unlike;
  for (const EdgePair& pair : pairs) {
    const EdgeNodes& given = boundary.edges[pair.given.index()];
    EdgeNodes& found = boundary.edges[pair.found.index()];
    const std::size_t count = given.nodes.size();
    if (found.nodes.size() != count) {
      unlike.push_back(pair);
      continue;
    }
    for (std::size_t k = 1; k + 1 < count; ++k) {
      const std::size_t i = pair.reversed ? count - 1 - k : k;
      BoundaryNode& node = boundary.nodes[found.nodes[i].index()];
      if (node.vertex.valid()) continue;
      const Vec3 place = pair.motion * boundary.nodes[given.nodes[k].index()].xyz;
      node.t = found.params[i] = parameter_at(evaluator, pair.found, found.params[i], place);
      node.xyz = evaluator.edge_point(pair.found, node.t);
      if ((node.xyz - place).norm() <= kOnShape * evaluator.model().diagonal()) node.xyz = place;
    }
  }
  return unlike;
}

}  // namespace advlayers
