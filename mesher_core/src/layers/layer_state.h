// What the steps of one layer share.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "layers/corner_class.h"
#include "layers/front.h"
#include "layers/layer_steps.h"
#include "layers/patch_layers.h"
#include "layers/reconnect.h"

namespace advlayers {

// Regular vertices of the first layers stay where they were extruded to, along the bisector and at
// the height that was asked for.
inline constexpr int kStraightLayers = 5;

struct LayerState {
  const RunContext& context;
  PatchId patch;
  SurfaceMesh& mesh;
  PatchSurface& surface;
  Front front;
  double max_height;
  bool stop_at_isotropy;
  LayerSteps steps;
  ReconnectLimits limits{};
  SwapQueue swaps;
  int layer = 0;
  LayerReport report{};  // of this layer
  std::vector<Diagnostic> diagnostics{};
  std::vector<StopRecord> stops{};
  LocalSize local_size{};  // where layers end at it

  void count_event(Event event) { ++report.events[static_cast<std::size_t>(event)]; }

  // Why the node's column ends.
  void note_stop(int node, Stop reason) {
    ++report.stops[static_cast<std::size_t>(reason)];
    stops.push_back({front[node].root, reason, layer});
  }
};

}  // namespace advlayers
