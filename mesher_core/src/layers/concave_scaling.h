// How much farther a corner's kid is placed than its neighbours' (paper, II.G).
#pragma once

#include "layers/front.h"

namespace advlayers {

// The factor on the height [1]. Concave corners that turn more than 20 degrees: eq. 9 where A > cot
// theta, else 1 / sin theta, never past the shorter neighbour edge. Convex corners: 1 / sin theta,
// so that the layer keeps its thickness. Elsewhere 1.
double concave_factor(const NodeShape& shape, double height);

}  // namespace advlayers
