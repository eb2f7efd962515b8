// What of a shape lies within its own tolerances and is one point there. For the sources of
// geometry/ alone.
#pragma once

#include <vector>

#include "geometry/evaluator.h"
#include "geometry/model.h"

namespace advlayers {

// Edges no longer than the tolerance about them become degenerate, and their ends one vertex, the
// first of those that so fall together.
void contract_short_edges(const std::vector<Vertex>& vertices, std::vector<Edge>& edges);

// A degenerate edge is a pole where the surface itself shrinks to a point. Elsewhere it closes a
// gap in the boundary and is taken out of it, and loops of nothing else with it; a face without
// any other loop has a defect.
void remove_false_poles(Evaluator& evaluator, std::vector<Face>& faces);

}  // namespace advlayers
