// Noses and folds of a face whose radius is far below any edge length worth having: the tip of a
// blade, a rounding that a loft let shrink to nothing. Halving edges there would chase the radius.
#pragma once

#include "base/run_context.h"
#include "triangulate/lifted_triangulation.h"

namespace advlayers {

// Divides every edge over such a fold where the normal has turned by half, or takes an end near to
// that place for it. The vertices on the fold are marked as creases: no triangle is left that
// reaches across. Throws Cancelled.
void split_creases(const RunContext& context, LiftedTriangulation& sheet);

}  // namespace advlayers
