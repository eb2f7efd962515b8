// Decimation of core vertices ahead of the front (paper, II.F, eq. 1 and Fig. 7).
#pragma once

#include "layers/layer_state.h"

namespace advlayers {

// Removes core vertices joined to an active front vertex that are nearer than
// max(l1 / sqrt 2, l2 / sqrt 2, 2 h). Where the paper's limits refuse, a vertex stays unless it is
// nearer than 1.5 h: that one would lie in the layer itself.
void make_way(LayerState& state);

}  // namespace advlayers
