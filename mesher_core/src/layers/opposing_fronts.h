// What lies ahead of each front vertex: how wide the gap to the opposing front is, and how far the
// vertex should slide along its own front until both meet node to node. Fronts that meet out of
// step cost a triangle or a crushed quad for each edge (past the paper's II.J).
#pragma once

#include <limits>
#include <vector>

#include "layers/layer_state.h"

namespace advlayers {

struct Opposite {
  double gap = std::numeric_limits<double>::infinity();  // [mm]; infinite: nothing within reach
  double slide = 0.0;  // of the next kid along the front, towards next(node) [mm]
};

// By front node. `shapes` are those of the active nodes, `heights` their next heights [mm]. Fronts
// are seen from 3 heights off, and aligned from 2.5 front edges off, once the first layers are
// made.
std::vector<Opposite> opposing_fronts(const LayerState& state, const std::vector<NodeShape>& shapes,
                                      const std::vector<double>& heights);

}  // namespace advlayers
