// Where the front must not go on: its edges would soon lie across a bend of the surface that is too
// tight for their length (the round leading edge of a blade, met at an angle).
#pragma once

#include "layers/layer_state.h"

namespace advlayers {

// Stops both ends of such edges while the core ahead still has room to become as fine as the bend
// asks for. Comes before anything is cleared away for the layer.
void stop_before_bends(LayerState& state);

}  // namespace advlayers
