// Redefinition of the front before a layer (paper, II.J): corners that would run into themselves
// are closed, and ends of narrow gaps are zipped, each event with the fewest triangles. Every event
// takes nodes out of the front, so the loop ends.
#pragma once

#include "layers/layer_state.h"

namespace advlayers {

// Needs: a valid mesh, a front whose edges exist in it. Leaves both so.
void close_front(LayerState& state);

}  // namespace advlayers
