#include "layers/patch_layers.h"

#include <utility>

#include "layers/bends_ahead.h"
#include "layers/chain_end.h"
#include "layers/close_front.h"
#include "layers/complete_columns.h"
#include "layers/insert_layer.h"
#include "layers/layer_plan.h"
#include "layers/layer_state.h"
#include "layers/make_way.h"
#include "layers/smooth.h"

namespace advlayers {

namespace {

struct LayerStep {
  Step id;
  const char* name;
  void (*run)(LayerState& state, LayerPlan& plan);
};

// Algorithm 1, lines 8 to 17: what one layer takes, in this order. The front is collapsed in the
// plan, before anything is inserted.
constexpr std::array<LayerStep, 9> kLayerSteps{{
    {Step::kMakeWay, "make-way",
     [](LayerState& state, LayerPlan&) {
       stop_before_bends(state);
       make_way(state);
     }},
    {Step::kRedefine, "redefine",
     [](LayerState& state, LayerPlan&) {
       ChainEnds::join_facing(state);
       close_front(state);
     }},
    {Step::kCollapse, "collapse",
     [](LayerState& state, LayerPlan& plan) { plan = plan_layer(state); }},
    {Step::kExtrude, "extrude", insert_kids},
    {Step::kRecover, "recover", recover_cells},
    {Step::kCombine, "combine",
     [](LayerState& state, LayerPlan& plan) { combine_cells(state, plan); }},
    {Step::kSmooth, "smooth",
     [](LayerState& state, LayerPlan& plan) {
       if (state.steps.smoothing) smooth_layer(state, plan);
     }},
    {Step::kImprove, "improve",
     [](LayerState& state, LayerPlan&) { state.swaps.run(state.limits, state.report.vetoes); }},
    {Step::kGrow, "grow",
     [](LayerState& state, LayerPlan& plan) {
       advance_front(state, plan);
       end_complete_columns(state, state.layer + 1);
     }},
}};
static_assert(in_order(kLayerSteps));

}  // namespace

const char* step_name(Step step) { return kLayerSteps[static_cast<std::size_t>(step)].name; }

struct PatchLayers::Impl {
  LayerState state;
  StepHook hook;

  Impl(const RunContext& context, PatchId patch, SurfaceMesh& mesh, PatchSurface& surface,
       const WallPlan& plan, const LayerSteps& steps)
      : state{context,
              patch,
              mesh,
              surface,
              Front(mesh, plan),
              plan.max_height,
              plan.stop_at_isotropy,
              steps,
              ReconnectLimits{},
              SwapQueue(mesh)} {}

  void advance_layer() {
    LayerPlan plan;
    for (const LayerStep& step : kLayerSteps) {
      step.run(state, plan);
      if (hook) hook(step.id, state.mesh);
      state.context.check();
    }
  }
};

PatchLayers::PatchLayers(const RunContext& context, PatchId patch, SurfaceMesh& mesh,
                         PatchSurface& surface, const WallPlan& plan, const LayerSteps& steps)
    : impl_(std::make_unique<Impl>(context, patch, mesh, surface, plan, steps)) {}
PatchLayers::~PatchLayers() = default;

std::optional<LayerReport> PatchLayers::advance() {
  LayerState& state = impl_->state;
  state.report = LayerReport();
  if (state.layer == 0) end_complete_columns(state, 1);
  if (state.front.active_count() == 0) return std::nullopt;
  state.report.patch = state.patch;
  state.report.layer = ++state.layer;
  impl_->advance_layer();
  state.report.front_vertices = state.front.active_count();
  return state.report;
}

void PatchLayers::set_step_hook(StepHook hook) { impl_->hook = std::move(hook); }
void PatchLayers::set_local_size(LocalSize size) { impl_->state.local_size = std::move(size); }
const std::vector<Diagnostic>& PatchLayers::diagnostics() const { return impl_->state.diagnostics; }
const std::vector<StopRecord>& PatchLayers::stops() const { return impl_->state.stops; }

void thaw_core_edges(SurfaceMesh& mesh) {
  const auto in_core = [&](HalfedgeH h) {
    return !mesh.is_border(h) && mesh.is_triangle(h) && mesh.data(mesh.face(h)).layer == 0;
  };
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
    const HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.frozen(h)) continue;
    if (in_core(h) && in_core(SurfaceMesh::twin(h))) mesh.set_frozen(h, false);
  }
}

}  // namespace advlayers
