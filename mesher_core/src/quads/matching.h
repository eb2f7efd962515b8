// Pairs the nodes of a sparse graph, each with at most three neighbours (the dual of a triangle
// mesh), so that few stay alone and the pairs weigh much. Near-linear: greedy by weight, then
// augmenting paths (Edmonds' blossoms, each search bounded), then exchanges along short alternating
// cycles and paths. An exact maximum-weight matching costs the cube of the nodes.
#pragma once

#include <vector>

#include "base/run_context.h"

namespace advlayers {

struct PairEdge {
  int a = 0, b = 0;
  double weight = 0.0;  // > 0
};

// The matched edge of each node as an index into `edges`; -1: alone. Deterministic.
// Throws InternalError where a node has more than three edges, and Cancelled.
std::vector<int> match_pairs(const RunContext& context, int nodes,
                             const std::vector<PairEdge>& edges);

}  // namespace advlayers
