// Quads of 8 and triangles of 6 nodes: whether the curved element can be mapped from the straight
// one, node by node.
#pragma once

#include <array>

#include "base/types.h"

namespace advlayers {

// Corners counter-clockwise; mid node k lies between corners k and k + 1. Three or four are used.
struct CurvedElement {
  std::array<Vec3, 4> corners, mids;
  int count = 0;
};

// The least over all nodes, and the middle, of the Jacobian determinant, as a part of that of the
// same element with straight sides; both are seen along the straight element's normal. 1: straight;
// 0 and below: turned over at a node. Where the straight element itself is, a node is left out.
double least_jacobian(const CurvedElement& element);

}  // namespace advlayers
