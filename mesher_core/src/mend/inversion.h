// Elements that are turned over against the surface, and their repair.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// True where the element's normal points against the surface's at the foot of its centroid, or
// where it has no area. The measure of the report and the bars.
bool is_inverted(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface);

// True where it is turned over, or leans so far that it makes a fold with its neighbours.
bool is_steep(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface);

// Tries to turn inverted elements back by flips, by cutting the pentagon with a neighbour anew, by
// dividing quads: whichever leaves fewer inverted. Layers are cut into where nothing else helps;
// the border stays. Returns the number of elements still inverted. Throws Cancelled.
int mend_inverted(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface);

}  // namespace advlayers
