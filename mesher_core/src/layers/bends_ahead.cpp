#include "layers/bends_ahead.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/angles.h"
#include "base/directions.h"

namespace advlayers {
namespace {

constexpr double kMostEdgeBend = 40.0 * kDegree;  // of the surface along a front edge
// The core shrinks from a front edge's length to nearly nothing within so many of its lengths. Low
// layers matter more than a core of even grading: they go on up to so many heights.
constexpr double kRoomInLengths = 2.0;
constexpr double kRoomInHeights = 6.0;
constexpr std::size_t kMostReached = 200;  // core vertices that are asked
constexpr std::size_t kLooks = 4;          // along the way ahead
// Edges in a row: the few that meet a corner's rounding pass by or over it.
constexpr int kShortestRun = 4;

using Normals = std::array<Vec3, kLooks>;  // ever farther ahead; zero where the surface ends

class BendFinder {
 public:
  explicit BendFinder(LayerState& state)
      : state_(state),
        mesh_(state.mesh),
        ahead_(state.front.nodes().size()),
        asked_by_(state.mesh.vertex_capacity()) {}

  // Whether the edge from node i to node k would lie across a bend within reach.
  bool before_bend(int i, int k) {
    const double now = angle_between(normal(i), normal(k));
    if (!look(i).turns && !look(k).turns) return false;
    const double most = std::max(kMostEdgeBend, now);
    const Normals &a = normals(i), &b = normals(k);
    for (std::size_t n = 0; n < kLooks; ++n) {
      if (!a[n].isZero() && !b[n].isZero() && angle_between(a[n], b[n]) > most) return true;
    }
    return false;
  }

 private:
  struct Ahead {
    bool looked = false, walked = false;
    bool turns = false;  // the core within reach
    double reach = 0.0;  // [mm]
    NodeShape shape;
    Normals normals;
  };

  const Vec3& normal(int i) const { return mesh_.data(state_.front[i].vertex).normal; }

  const Ahead& look(int i) {
    Ahead& ahead = ahead_[static_cast<std::size_t>(i)];
    if (ahead.looked) return ahead;
    const FrontNode& node = state_.front[i];
    ahead.looked = true;
    ahead.shape = node_shape(mesh_, state_.front, i);
    const double height = std::min(node.growth.height, state_.max_height);
    ahead.reach = std::min(kRoomInLengths * ahead.shape.length(), kRoomInHeights * height);
    ahead.turns = core_turns(node.vertex, ahead.reach);
    return ahead;
  }

  // Looking ahead on the surface itself costs far more.
  bool core_turns(VertexH node, double reach) {
    std::vector<VertexH> reached{node};
    for (std::size_t k = 0; k < reached.size(); ++k) {
      for (const HalfedgeH h : mesh_.around(reached[k])) {
        const VertexH w = mesh_.to(h);
        const bool near = (mesh_.position(w) - mesh_.position(node)).norm() <= reach;
        if (!near || !is_core_vertex(mesh_, w)) continue;
        if (std::exchange(asked_by_[w.index()], node) == node) continue;
        const double turn = angle_between(mesh_.data(w).normal, mesh_.data(node).normal);
        if (turn > kMostEdgeBend || reached.size() > kMostReached) return true;
        reached.push_back(w);
      }
    }
    return false;
  }

  const Normals& normals(int i) {
    look(i);
    Ahead& ahead = ahead_[static_cast<std::size_t>(i)];
    if (ahead.walked) return ahead.normals;
    ahead.walked = true;
    ahead.normals.fill(Vec3::Zero());
    SurfacePoint at = mesh_.data(state_.front[i].vertex).point;
    Vec3 heading = ahead.shape.inward;
    for (Vec3& there : ahead.normals) {
      SurfacePoint to;
      if (!state_.surface.step(at, heading, ahead.reach / kLooks, to)) break;
      there = state_.surface.normal(to);
      heading = to.xyz - at.xyz;
      at = to;
    }
    return ahead.normals;
  }

  LayerState& state_;
  const SurfaceMesh& mesh_;
  std::vector<Ahead> ahead_;       // by front node
  std::vector<VertexH> asked_by_;  // by vertex: the last front vertex that looked at it
};

}  // namespace

void stop_before_bends(LayerState& state) {
  Front& front = state.front;
  BendFinder finder(state);
  std::vector<char> stops(front.nodes().size(), 0);
  const auto stopped = [&](int i) { return stops[static_cast<std::size_t>(i)] != 0; };
  for (int i = 0; i < front.size(); ++i) {
    const int k = front[i].next;
    if (k < 0 || !front[i].active || !front[k].active) continue;
    state.context.check();
    if (!finder.before_bend(i, k)) continue;
    stops[static_cast<std::size_t>(i)] = stops[static_cast<std::size_t>(k)] = 1;
  }
  const auto run = [&](int i, int FrontNode::*onward) {
    int n = 0;
    for (int k = front[i].*onward; k >= 0 && k != i && n < kShortestRun && stopped(k);
         k = front[k].*onward) {
      ++n;
    }
    return n;
  };
  for (int i = 0; i < front.size(); ++i) {
    if (!stopped(i) || run(i, &FrontNode::next) + run(i, &FrontNode::prev) < kShortestRun) continue;
    state.note_stop(i, Stop::kBent);
    front[i].active = false;
  }
}

}  // namespace advlayers
