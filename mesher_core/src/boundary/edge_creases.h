// Where an edge runs over a fold of its face that is too sharp for any mesh edge to follow.
#pragma once

#include <vector>

#include "base/angles.h"
#include "boundary/edge_spacing.h"

namespace advlayers {

// A fold: the normal turns this far along an edge that runs over it [rad], and this part of the
// turn lies close together.
inline constexpr double kLeastFoldTurn = 60.0 * kDegree;
inline constexpr double kMostOfFold = 0.6;

// Parameters inside the edge's range, rising, in the middle of such folds: there the normals of a
// face beside the edge turn by 60 degrees or more within `least` [mm]. A node belongs there, for no
// mesh edge is to reach from one side of a fold to the other.
std::vector<double> edge_creases(Evaluator& evaluator, EdgeId edge,
                                 const std::vector<EdgeSpacing::Side>& sides, double least);

}  // namespace advlayers
