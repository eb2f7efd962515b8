// Improves the triangles that no layer has reached, once the layers have stopped: splits of edges
// across bends, flips for the larger minimum angle (paper, II.D), tangential smoothing.
// Fronts, parent-kid edges and the CAD's boundary stay as they are.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// The mesh is a valid mesh of the patch before and after. Throws Cancelled.
void improve_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface);

}  // namespace advlayers
