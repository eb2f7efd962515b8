// What is made of the core of a patch once its layers have ended.
#pragma once

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "measure/layer_cells.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

inline constexpr int kAllMayCross = -1;  // the edges were not followed

struct Completion {
  int crossing = 0;          // elements that reach over edges inside the patch; kAllMayCross
  int of_layers_mended = 0;  // elements of layers that were to stay, and could not
};

// Fills the core anew, recombines it where quads are asked for, and mends what is turned over;
// `cells` says what becomes of the last layers. The mesh is a valid mesh of the patch before and
// after. Throws Cancelled.
Completion complete_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                         Evaluator& evaluator, const Settings& settings, LayerCells cells);

// The same for a patch of several faces: the layers ran across the edges between these; here every
// element comes to lie on one face.
Completion complete_core_along_edges(const RunContext& context, SurfaceMesh& mesh,
                                     PatchSurface& surface, Evaluator& evaluator,
                                     const Discretization& boundary, const Settings& settings,
                                     LayerCells cells);

// Elements that are turned over against the surface. Throws Cancelled.
int count_inverted(const RunContext& context, const SurfaceMesh& mesh, PatchSurface& surface);

}  // namespace advlayers
