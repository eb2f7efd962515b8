// What is made of the core of a patch once its layers have ended.
#pragma once

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

// Improves the core, recombines it where quads are asked for, and mends what is turned over. The
// mesh is a valid mesh of the patch before and after. Throws Cancelled.
void complete_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                   const Settings& settings);

inline constexpr int kAllMayCross = -1;

// The same for a patch of several faces: the layers ran across the edges between these; here every
// element comes to lie on one face. Where that would cost an element turned over, elements reach
// over the edges instead. Returns how many do; kAllMayCross where the edges were not followed.
int complete_core_along_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                              const Discretization& boundary, const Settings& settings);

}  // namespace advlayers
