// Elements that are turned over against the surface, and their repair.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "measure/layer_cells.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// True where the element's normal points against the surface's at the foot of its centroid, or
// where it has no area. The measure of the report and the bars.
bool is_inverted(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface);

// True where it is turned over, or leans so far that it makes a fold with its neighbours.
bool is_steep(const SurfaceMesh& mesh, FaceH face, PatchSurface& surface);

// Tries to turn inverted elements back by flips, by cutting the pentagon with a neighbour anew, by
// dividing quads: whichever leaves fewer inverted. Layers are cut into where nothing else helps,
// those that are to stay only where an element is turned over or folded; the border stays. Throws
// Cancelled.
struct Mended {
  int left = 0;       // elements still faulty
  int of_layers = 0;  // that were to stay, and were changed
};
Mended mend_inverted(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                     LayerCells cells = LayerCells::kTraded);

}  // namespace advlayers
