// Keeps the edges of a shrinking front from getting shorter than the layer is high (paper, II.F).
#pragma once

#include "layers/plan_draft.h"

namespace advlayers {

// Three short edges become one with quads alone, where the front is straight.
void coarsen_front(PlanDraft& draft);
// Kids nearer to each other than 2 tan(pi/8) h, or that have passed each other, become one at their
// mean (Fig. 6, before insertion instead of after). Shortest first. Each costs a triangle.
void merge_close_kids(PlanDraft& draft);

}  // namespace advlayers
