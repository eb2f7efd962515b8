// Where a point falls in a sheet, and whether there is room for it.
#pragma once

#include <limits>

#include "triangulate/lifted_triangulation.h"

namespace advlayers {

// The triangle that holds p, reached from t without crossing a boundary; -1 where the walk comes to
// an end before.
int walk_to(const PlanarTriangulation& mesh, int t, const Vec2& p);

// Whether a point of triangle t would lie too near to its corners or to a border, for the sizes
// wanted at the corners and that asked for at the point itself [mm], if that is less.
bool crowds(LiftedTriangulation& sheet, int t, const Vec2& p,
            double own_size = std::numeric_limits<double>::infinity());

}  // namespace advlayers
