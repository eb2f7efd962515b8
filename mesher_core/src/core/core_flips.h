// Flips core edges for the larger minimum angle (paper, II.D).
#pragma once

#include <vector>

#include "base/run_context.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Flips until no flip of a core edge enlarges the smallest angle of its two triangles. A flip is
// refused where a new triangle would lean from the surface by more than 30 degrees and more than
// either old one does. Returns the number of flips. Throws Cancelled.
int flip_core(const RunContext& context, SurfaceMesh& mesh);

}  // namespace advlayers
