// Takes out vertices that crowd the core, as cutting it along edges of the CAD leaves them.
#pragma once

#include "base/run_context.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Collapses the shortest sides of the core's poor triangles where all triangles about it gain. A
// vertex on an edge inside the patch moves along that edge alone; those of the border, of layers
// and of the CAD stay. Returns the number of vertices taken out. Throws Cancelled.
int collapse_slivers(const RunContext& context, SurfaceMesh& mesh);

}  // namespace advlayers
