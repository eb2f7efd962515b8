#include "layers/layer_plan.h"

#include "layers/extrude_front.h"
#include "layers/layer_cells.h"
#include "layers/layer_heights.h"
#include "layers/plan_draft.h"
#include "layers/row_ends.h"
#include "layers/thin_front.h"

namespace advlayers {

LayerPlan plan_layer(LayerState& state) {
  PlanDraft draft(state);
  set_heights(draft);
  step_chain_ends(draft);
  if (state.steps.row_ends) end_rows(draft);
  extrude_front(draft);
  if (state.steps.coarsening) coarsen_front(draft);
  merge_close_kids(draft);
  plan_cells(draft);
  return std::move(draft.plan);
}

}  // namespace advlayers
