// Triangles as a shell of planar faces. For the sources of geometry/ alone.
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <vector>

#include "base/types.h"

namespace advlayers {

// One face for each triangle that has an area, in their order; those given twice count once.
// Corners that lie within a millionth of the box's diagonal of each other are one: an STL file has
// them only up to its precision. Null without a face.
TopoDS_Shape shape_of_triangles(const std::vector<std::array<Vec3, 3>>& triangles);

}  // namespace advlayers
