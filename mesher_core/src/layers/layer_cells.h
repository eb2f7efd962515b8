// The cells that the planned kids close.
#pragma once

#include "layers/plan_draft.h"

namespace advlayers {

void plan_cells(PlanDraft& draft);

}  // namespace advlayers
