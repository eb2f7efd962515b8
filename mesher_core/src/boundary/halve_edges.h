// Cuts some CAD edges twice as fine, for faces whose boundary was cut too coarsely to be meshed.
#pragma once

#include <vector>

#include "boundary/discretization.h"

namespace advlayers {

// Halves every mesh edge on these CAD edges by the length of the curve. Nodes keep their numbers,
// new ones come after them. Degenerate edges stay.
// Throws Cancelled.
void halve_edges(const RunContext& context, Evaluator& evaluator, const std::vector<EdgeId>& edges,
                 Discretization& boundary);

}  // namespace advlayers
