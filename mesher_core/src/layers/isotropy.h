// Where growth ends because the layers have become as high as the front's edges are long.
#pragma once

#include <vector>

#include "layers/front.h"

namespace advlayers {

// The nodes that end for isotropy: their height reaches their edges' length, and no node along the
// front still needs more layers for it than it is edges away. So columns that end for it differ by
// one layer at most from their neighbours, and those beside a fan, whose edges are never longer
// than they are high, do not end at once. `shapes` by front node.
std::vector<char> isotropic_nodes(const Front& front, const std::vector<NodeShape>& shapes);

}  // namespace advlayers
