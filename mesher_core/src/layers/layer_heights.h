// How high the next layer is at each front vertex, and which vertices stop before it.
#pragma once

#include "layers/plan_draft.h"

namespace advlayers {

// Measures the front, and caps the heights where fronts draw near: opposing fronts meet evenly.
// Where two more rows would leave less than one, the height is a third of the gap; where not even
// two fit, the column stops.
void set_heights(PlanDraft& draft);

}  // namespace advlayers
