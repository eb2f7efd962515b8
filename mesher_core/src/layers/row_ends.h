// Rows of quads that end at a corner of the front, with quads alone (paving's end class).
#pragma once

#include "layers/plan_draft.h"

namespace advlayers {

// Gives the corners where a row ends, and their neighbours, one kid to share. Before extrusion.
void end_rows(PlanDraft& draft);

}  // namespace advlayers
