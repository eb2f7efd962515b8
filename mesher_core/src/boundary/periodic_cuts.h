// Periodic edges: cut alike, their nodes as exact copies of each other.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "boundary/periodic_pairs.h"
#include "boundary/stretch.h"

namespace advlayers {

// Gives both edges of a pair as many segments, at the places of the given one's. Pairs whose edges
// are divided into different numbers of stretches stay as they are.
void cut_alike(const RunContext& context, const std::vector<EdgePair>& pairs, Stretches& stretches);

// A copy this near to the shape, over the model's diagonal, lies on it.
inline constexpr double kOnShape = 1e-9;

// Moves the nodes inside the found edges to where the motion brings those of the given ones; where
// it is not exact, and that is beside the curve, to the nearest point on it.
// Returns the pairs with different numbers of nodes.
std::vector<EdgePair> place_alike(Evaluator& evaluator, const std::vector<EdgePair>& pairs,
                                  Discretization& boundary);

}  // namespace advlayers
