// Smoothing of the newest layer by springs (paper, II.I). Eq. 12 pulls a vertex towards the mean of
// its neighbours, along the front only, so that heights keep; eqs. 10 and 11 restore the height;
// eq. 13 holds it near where it was extruded.
#pragma once

#include "layers/layer_plan.h"

namespace advlayers {

// Moves the kids beside corners, collapses and row ends; kids of an even front stay where they were
// extruded. A move that would turn an element over is vetoed.
void smooth_layer(LayerState& state, const LayerPlan& plan);

}  // namespace advlayers
