// Mends the seams where fronts have met. What is left between them may be much thinner than the
// front's edges are long; no vertex there is free, and swaps and smoothing alone cannot help.
#pragma once

#include "base/run_context.h"
#include "measure/layer_cells.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Cuts the pentagon that a bad triangle makes with a quad beside it, across the front if need be,
// at the corner that gives the best shapes: a triangle flat on a front edge moves into the layer
// below, if that may be traded. After recombination. Returns the number of pentagons cut anew.
// Throws Cancelled.
int recut_pentagons(const RunContext& context, SurfaceMesh& mesh,
                    LayerCells cells = LayerCells::kTraded);

}  // namespace advlayers
