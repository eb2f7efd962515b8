#include "layers/complete_columns.h"

#include <vector>

#include "layers/isotropy.h"

namespace advlayers {
namespace {

void end(LayerState& state, int i, Stop reason, int not_made) {
  ++state.report.stops[static_cast<std::size_t>(reason)];
  state.stops.push_back({state.front[i].root, reason, not_made});
  state.front[i].active = false;
}

void end_isotropic(LayerState& state, int not_made) {
  const Front& front = state.front;
  std::vector<NodeShape> shapes(front.nodes().size());
  for (int i = 0; i < front.size(); ++i) {
    const FrontNode& node = front[i];
    if (!node.active || (node.prev < 0 && node.next < 0)) continue;
    shapes[static_cast<std::size_t>(i)] = node_shape(state.mesh, front, i);
  }
  const std::vector<char> isotropic = isotropic_nodes(state, shapes);
  for (int i = 0; i < front.size(); ++i) {
    if (front[i].active && isotropic[static_cast<std::size_t>(i)] != 0) {
      end(state, i, Stop::kIsotropic, not_made);
    }
  }
}

}  // namespace

void end_complete_columns(LayerState& state, int not_made) {
  Front& front = state.front;
  for (int i = 0; i < front.size(); ++i) {
    if (front[i].active && front[i].growth.layers_left <= 0) {
      end(state, i, Stop::kLayersReached, not_made);
    }
  }
  if (state.stop_at_isotropy) end_isotropic(state, not_made);
  const auto goes_on = [&](int k) { return k >= 0 && front[k].active; };
  for (int i = 0; i < front.size(); ++i) {
    if (!front[i].active || goes_on(front[i].prev) || goes_on(front[i].next)) continue;
    end(state, i, Stop::kNeighbour, not_made);
  }
}

}  // namespace advlayers
