// Where the kids of one layer go (paper, II.C; corner classes as in paving).
#pragma once

#include "layers/plan_draft.h"

namespace advlayers {

// The kids of open chains' ends, see chain_end.h.
void step_chain_ends(PlanDraft& draft);
// One kid for each node that has none yet, several at a convex corner of the CAD. Nodes that cannot
// be extruded stop.
void extrude_front(PlanDraft& draft);

}  // namespace advlayers
