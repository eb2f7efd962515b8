// Measures, on the finished mesh of a patch, what became of each wall.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "layers/wall_plan.h"
#include "mesh/surface_mesh.h"
#include "mesher/result.h"

namespace advlayers {

// One report per wall edge of the patch, by edge, without its face. Heights are arc lengths on the
// surface of the parent-kid edges, over regular wall vertices: one kid, and a wall that turns less
// than 20 degrees there and within two edges on either side; over the straight ones, or all, with
// one kid where none is regular.
//
// `layers` are complete along the whole edge: in the mesh on every column but those that met
// another front or column (closed, merged), where there was no room for more. Throws Cancelled.
std::vector<WallReport> measure_walls(const RunContext& context, const SurfaceMesh& mesh,
                                      PatchSurface& surface, const WallPlan& plan,
                                      const std::vector<StopRecord>& stops, int layers_made);

// Length [mm] along the surface of the curve above a mesh edge: the chord, corrected by the
// projected midpoint (Richardson extrapolation of one halving).
double arc_length(PatchSurface& surface, const SurfacePoint& from, const SurfacePoint& to);

}  // namespace advlayers
