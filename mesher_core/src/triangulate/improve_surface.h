// Improves a glued triangulation in space, on the exact surface: no length, angle or orientation is
// taken from (u, v) any more. Borders and tips stay.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "triangulate/glue.h"

namespace advlayers {

// Whether vertices are moved to even out their neighbourhood, or only where a triangle is poor.
enum class Places { kEvened, kKept };

// Flips, smooths, divides long edges and removes short ones until triangles are isotropic and
// within the deviation bound, as far as the boundary lets them be.
void improve_surface(const RunContext& context, GluedMesh& glued, PatchSurface& surface,
                     Places places);

}  // namespace advlayers
