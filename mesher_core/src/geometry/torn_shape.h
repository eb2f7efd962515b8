// Whether the parts of a shape lie where they should. For the sources of geometry/ alone.
#pragma once

#include <TopoDS_Shape.hxx>

namespace advlayers {

// Throws InvalidInput, naming face and edge, where a face has no end, or where an edge, or the
// vertex at an end of it, lies off its face by more than a hundredth of the box around all
// vertices: readers join what a damaged number has torn apart by a tolerance as large as the gap.
void refuse_torn_shape(const TopoDS_Shape& shape);

}  // namespace advlayers
