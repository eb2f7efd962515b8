// Where an edge runs over a fold of its face that is too sharp for any mesh edge to follow.
#pragma once

#include <vector>

#include "boundary/edge_spacing.h"

namespace advlayers {

// Parameters inside the edge's range, rising, in the middle of such folds: there the normals of a
// face beside the edge turn by 60 degrees or more within `least` [mm]. A node belongs there, for no
// mesh edge is to reach from one side of a fold to the other.
std::vector<double> edge_creases(Evaluator& evaluator, EdgeId edge,
                                 const std::vector<EdgeSpacing::Side>& sides, double least);

}  // namespace advlayers
