// Puts the core's points, row by row from its border.
#pragma once

#include "base/run_context.h"
#include "core/core_field.h"
#include "core/core_room.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// A point is set where the four arms of a point's cross end, unless there is one near. `field`
// grows with the mesh; rows even out towards the border they end at. The vertices that were inside
// the room are gone afterwards. Where points of refinement ask for less than the field, they get
// it. Throws Cancelled.
void place_points(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const CoreRoom& room, TargetSize& target, CoreField& field);

}  // namespace advlayers
