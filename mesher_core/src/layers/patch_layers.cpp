#include "layers/patch_layers.h"

#include <utility>

#include "layers/bends_ahead.h"
#include "layers/chain_end.h"
#include "layers/close_front.h"
#include "layers/insert_layer.h"
#include "layers/layer_plan.h"
#include "layers/layer_state.h"
#include "layers/make_way.h"
#include "layers/smooth.h"

namespace advlayers {

const char* step_name(Step step) {
  static constexpr std::array<const char*, 9> kNames{"make-way", "redefine", "extrude",
                                                     "recover",  "improve",  "combine",
                                                     "smooth",   "collapse", "grow"};
  return kNames[static_cast<std::size_t>(step)];
}

const char* stop_name(Stop stop) {
  static constexpr std::array<const char*, kStopCount> kNames{
      "layers-reached", "isotropic", "collision",         "closed",
      "blocked",        "merged",    "neighbour-stopped", "surface-bends"};
  return kNames[static_cast<std::size_t>(stop)];
}

const char* event_name(Event event) {
  static constexpr std::array<const char*, kEventCount> kNames{
      "collapse", "coarsen", "row-end", "close-triangle", "zip", "rung", "bridge", "fan"};
  return kNames[static_cast<std::size_t>(event)];
}

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

  void done(Step step) const {
    if (hook) hook(step, state.mesh);
    state.context.check();
  }

  // Algorithm 1, lines 8 to 17. The front is collapsed in the plan, before anything is inserted.
  void advance_layer() {
    stop_before_bends(state);
    make_way(state);
    done(Step::kMakeWay);
    ChainEnds::join_facing(state);
    close_front(state);
    done(Step::kRedefine);
    LayerPlan plan = plan_layer(state);
    done(Step::kCollapse);
    insert_kids(state, plan);
    done(Step::kExtrude);
    recover_cells(state, plan);
    done(Step::kRecover);
    combine_cells(state, plan);
    done(Step::kCombine);
    if (state.steps.smoothing) smooth_layer(state, plan);
    done(Step::kSmooth);
    state.swaps.run(state.limits, state.report.vetoes);
    done(Step::kImprove);
    advance_front(state, plan);
    done(Step::kGrow);
  }
};

PatchLayers::PatchLayers(const RunContext& context, PatchId patch, SurfaceMesh& mesh,
                         PatchSurface& surface, const WallPlan& plan, const LayerSteps& steps)
    : impl_(std::make_unique<Impl>(context, patch, mesh, surface, plan, steps)) {}
PatchLayers::~PatchLayers() = default;

std::optional<LayerReport> PatchLayers::advance() {
  LayerState& state = impl_->state;
  if (state.front.active_count() == 0) return std::nullopt;
  state.report = LayerReport();
  state.report.patch = state.patch;
  state.report.layer = ++state.layer;
  impl_->advance_layer();
  state.report.front_vertices = state.front.active_count();
  return state.report;
}

void PatchLayers::set_step_hook(StepHook hook) { impl_->hook = std::move(hook); }
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
