// Patches too narrow for any layer: rows of quads from side to side.
#pragma once

#include <optional>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/four_sides.h"
#include "geometry/patch_surface.h"
#include "layers/wall_plan.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

// The sides of a patch of one face that is narrower than two sizes and whose walls along the long
// sides, by the first heights that they ask for, leave no room for a layer; or that has no walls.
// None where the core is to be triangles, or has the places of an initial mesh.
std::optional<FourSides> find_narrow_strip(const RunContext& context, Evaluator& evaluator,
                                           const std::vector<FaceId>& faces, const WallPlan& walls,
                                           const Settings& settings);

// Its finished mesh. None where layers do have room, where facing sides are cut into different
// numbers of segments, or where rows would make poor elements, leave the surface or be wider than
// the size: then the patch is meshed like any other. Throws Cancelled.
std::optional<SurfaceMesh> mesh_in_rows(const RunContext& context, Evaluator& evaluator,
                                        PatchSurface& surface, const Discretization& boundary,
                                        const FourSides& strip, const WallPlan& walls,
                                        const Settings& settings);

// Whether all angles of a mesh's elements lie between two [deg], and none is turned over, or leans
// so far that it makes a fold.
bool angles_within(const RunContext& context, const SurfaceMesh& mesh, PatchSurface& surface,
                   double least, double largest);

}  // namespace advlayers
