// Where a node on one long side of a strip asks for one that faces it on the other.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/four_sides.h"

namespace advlayers {

// Adds to the joints of edges (by EdgeId: parameters, rising, ends included; empty for edges that
// are not cut) until the long sides of every strip are divided alike.
void face_joints(const RunContext& context, Evaluator& evaluator,
                 const std::vector<FourSides>& strips, std::vector<std::vector<double>>& joints);

}  // namespace advlayers
