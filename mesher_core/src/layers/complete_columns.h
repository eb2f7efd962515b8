// Ends the columns that have what was asked for, before way is made for a layer that does not come.
#pragma once

#include "layers/layer_state.h"

namespace advlayers {

// Those with all their layers, and, where asked for, those that have become isotropic. `not_made`
// is the layer that they would have made next.
void end_complete_columns(LayerState& state, int not_made);

}  // namespace advlayers
