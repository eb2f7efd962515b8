// Starts a face's triangulation from points that are given: the nodes of an existing mesh.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "triangulate/lifted_triangulation.h"

namespace advlayers {

// Inserts points of the sheet's face, each where it lies, if there is room for it. Returns how many
// were. Their order matters no more than where several crowd each other. Throws Cancelled.
int insert_initial_points(const RunContext& context, LiftedTriangulation& sheet,
                          const std::vector<SurfacePoint>& points);

}  // namespace advlayers
