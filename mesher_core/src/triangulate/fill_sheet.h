// Places the interior points of a face, still in its sheet.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "triangulate/lifted_triangulation.h"

namespace advlayers {

// Before: a triangulation of the boundary points. After: nearly isotropic in the surface's metric,
// at the graded sizes, and near enough to the surface that every triangle faces outwards in space,
// as far as the boundary leaves room. The boundary stays as it is.
// `initial` points of the face come first, where they do not crowd each other or the border; the
// number of those taken is returned.
// Frontal insertion after Rebay, Efficient unstructured mesh generation by means of Delaunay
// triangulation and Bowyer-Watson algorithm (1993), with flips instead of cavities.
int fill_sheet(const RunContext& context, LiftedTriangulation& sheet,
               const std::vector<SurfacePoint>& initial);

}  // namespace advlayers
