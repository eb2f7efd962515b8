#include "layers/plan_draft.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"

namespace advlayers {
namespace {

constexpr int kFanLayers = 2;                // fan edges are exempt from collapse this long
constexpr double kEndTurn = 50.0 * kDegree;  // of both nodes at the end of a strip
constexpr double kLeastCellAngle =
    4.0 * kDegree;  // and its supplement at most: thin cells are sound

}  // namespace

PlanDraft::PlanDraft(LayerState& layer_state)
    : state(layer_state),
      mesh(layer_state.mesh),
      front(layer_state.front),
      heights(layer_state.front.nodes().size(), 0.0) {
  plan.shapes.resize(heights.size());
  plan.kids_of.resize(heights.size());
}

void PlanDraft::end(int i, Stop reason) {
  state.note_stop(i, reason);
  front[i].active = false;
  drop_kids_of(i);
}

void PlanDraft::drop_lone_nodes(Stop reason) {
  for (int i = 0; i < front.size(); ++i) {
    if (!advances(i)) continue;
    const auto goes_on = [&](int k) { return k >= 0 && advances(k); };
    if (!goes_on(front[i].prev) && !goes_on(front[i].next)) end(i, reason);
  }
}

int PlanDraft::add_kid(int node, const SurfacePoint& point) {
  const FrontNode& parent = front[node];
  Kid made;
  made.point = point;
  made.normal = state.surface.normal(point);
  made.parents = {node};
  made.origin = node;
  made.growth = parent.growth.next();
  made.root = parent.root;
  if (parent.fan_age >= 0 && parent.fan_age < kFanLayers) made.fan_age = parent.fan_age + 1;
  plan.kids.push_back(std::move(made));
  kids_of(node).push_back(static_cast<int>(plan.kids.size()) - 1);
  return kids_of(node).back();
}

int PlanDraft::step_kid(int node, const Vec3& direction, double length) {
  SurfacePoint to;
  if (!state.surface.step(mesh.data(front[node].vertex).point, direction, length, to)) return -1;
  return add_kid(node, to);
}

void PlanDraft::drop_kids_of(int i) {
  for (const int k : kids_of(i)) kid(k).alive = false;
  kids_of(i).clear();
}

bool PlanDraft::is_strip_end(int i, int k) const {
  return shape(i).turn() > kEndTurn && shape(k).turn() > kEndTurn;
}

Corner PlanDraft::corner_of(const CellCorner& c) const {
  if (c.node >= 0) return corner(mesh, front[c.node].vertex);
  return {kid(c.kid).point.xyz, kid(c.kid).normal};
}

bool PlanDraft::convex(const Cell& cell) const {
  const std::size_t n = cell.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const double angle =
        inner_angle(corner_of(cell.corners[k]), corner_of(cell.corners[(k + 1) % n]),
                    corner_of(cell.corners[(k + 2) % n]));
    if (angle < kLeastCellAngle || angle > M_PI - kLeastCellAngle) return false;
  }
  return true;
}

}  // namespace advlayers
