// How much farther a corner's kid is placed than its neighbours' (paper, II.G).
#pragma once

#include "layers/front.h"

namespace advlayers {

// The factor on the height [1]: 1 / sin theta where the front turns more than 20 degrees, so that
// the layer keeps its thickness beside both edges, else 1. At concave corners never past the
// shorter neighbour edge. This is the limit of eq. 9 for long edges; the rest of eq. 9, which grows
// without bound as A nears cot theta, would throw the kid past the cell's convexity.
double concave_factor(const NodeShape& shape, double height);

}  // namespace advlayers
