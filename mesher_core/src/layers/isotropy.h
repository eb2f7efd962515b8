// Where growth ends because the layers have become as high as elements are to be long.
#pragma once

#include <vector>

#include "layers/layer_state.h"

namespace advlayers {

// The nodes that end for isotropy: their height reaches the lesser of their edges' length and the
// local size, or those edges have become clearly longer than that size; and no node along the front
// still needs more layers for it than it is edges away. So columns that end for it differ by one
// layer at most from their neighbours, and those beside a fan, whose edges are never longer than
// they are high, do not end at once. `shapes` by front node.
std::vector<char> isotropic_nodes(const LayerState& state, const std::vector<NodeShape>& shapes);

}  // namespace advlayers
