// The core made from the fronts: what the layers have left is emptied and filled anew.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

// Makes the core as fine as its elements are to be, for edges of the model to be cut into it; it
// is filled afterwards. Throws Cancelled.
void prepare_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  Evaluator& evaluator, const Settings& settings);

// Fills the room with triangles whose corners lie in rows and columns where they are to be paired,
// and that are nearly equilateral where not. Layers, their nodes and the border stay. Throws
// Cancelled.
void fill_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
               Evaluator& evaluator, const Settings& settings);

}  // namespace advlayers
