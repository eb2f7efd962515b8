// Cuts the long edges of a coarse core, so that fields over it can vary as they have to.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "triangulate/target_size.h"

namespace advlayers {

// Edges of the core become no longer than so many of the elements to come. Throws Cancelled.
void refine_room(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                 TargetSize& target, double longest);

}  // namespace advlayers
