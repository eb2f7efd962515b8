// Makes quads of the triangles that the layers left: pairs by right angles (paper, II.H), pairs
// the triangles that stayed alone where a few swaps bring two together, evens out the number of
// quads about a vertex, and smooths towards right angles.
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "measure/layer_cells.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// A quad is refused where a corner is below 14 or above 166 degrees: further than the paper's 30
// and 150 (II.H), as smoothing opens it; held to those, some pairs come apart for good.
inline constexpr double kLeastPairQuality = 0.03;  // 1 - cos 14

// Which passes are made: all, but where tests/bench measures what each is worth.
struct RecombineSteps {
  bool walks = true;      // of single triangles towards each other
  bool pairs = true;      // of triangles within layers taken out together
  bool pentagons = true;  // of a quad and a triangle cut anew
  bool smoothing = true;  // towards right angles
};

// The mesh is a valid mesh of the patch before and after; frozen edges and the vertices outside
// the core stay as they are, but for the last layers, where they are traded. Throws Cancelled.
void recombine(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
               LayerCells cells = LayerCells::kTraded, const RecombineSteps& steps = {});

}  // namespace advlayers
