// Brings mesh vertices onto the model's edges and vertices inside a patch.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "imprint/edge_crossings.h"

namespace advlayers {

// Vertices near to where their mesh edges cross an edge of the model move there, and one takes the
// place of each vertex of the model; only where the elements about it stay sound. `sides` follows.
// Returns the vertices of the model that none could take. Throws Cancelled.
std::vector<VertexId> snap_to_edges(const RunContext& context, SurfaceMesh& mesh,
                                    PatchSurface& surface, FaceSides& sides,
                                    EdgeCrossings& crossings);

}  // namespace advlayers
