// Splits core edges that cut across the surface's bends.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Splits core edges whose ends' normals differ by more than 32 degrees, at their projected
// midpoints, until none is left that a split helps: fronts that meet around a tight bend leave
// triangles that cut through the shape. Returns the number of splits. Throws Cancelled.
int split_bent_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface);

}  // namespace advlayers
