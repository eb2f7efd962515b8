// Takes pairs of triangles out where fronts met unevenly: the disc of elements between them is
// dissected anew into quads alone, if need be with the last layer's quads beside it, whose vertices
// then go.
//
//   t0 ---- t1                 t0 ---- t1            Two triangles with their bases on one side of
//   | \    / |      ->         |        |            a strip: three quads of the layer below give
//   x0-x1-x2-x3                x0      x3            way, and the strip's other side is met.
//   |  |  |  |                 | \    / |
//   p0-p1-p2-p3                p0-p1-p2-p3
#pragma once

#include "base/run_context.h"
#include "measure/layer_cells.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Returns the number of pairs taken out. The first layers and the border
// stay, or all layers. Throws Cancelled.
int close_triangle_pairs(const RunContext& context, SurfaceMesh& mesh,
                         LayerCells cells = LayerCells::kTraded);

}  // namespace advlayers
