#include "layers/chain_end.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "base/angles.h"
#include "base/directions.h"
#include "sizing/gap_rule.h"

namespace advlayers {
namespace {

constexpr double kSlide = 0.65;        // of the way to the next node, and the end goes there
constexpr double kCornerCosine = 0.8;  // the boundary goes on straight over a CAD vertex
constexpr double kLeastRoom = 0.9;     // heights that the next layer must find
constexpr double kHeightsSeen = 4.0;   // ahead along the boundary

// The boundary of the patch from a vertex away from the front.
class BorderWalk {
 public:
  BorderWalk(const SurfaceMesh& mesh, VertexH from, bool forward)
      : mesh_(mesh), at_(from), forward_(forward) {}
  // The next border half-edge in the walk's direction; it runs against the walk where that goes
  // forward (the inner side's way).
  HalfedgeH edge() const {
    const HalfedgeH out = mesh_.outgoing(at_);
    return forward_ ? mesh_.prev(out) : out;
  }
  VertexH next() const { return forward_ ? mesh_.from(edge()) : mesh_.to(edge()); }
  void advance() { at_ = next(); }
  VertexH at() const { return at_; }
  Vec3 step() const { return mesh_.position(next()) - mesh_.position(at_); }

 private:
  const SurfaceMesh& mesh_;
  VertexH at_;
  bool forward_;
};

}  // namespace

bool is_chain_end(const FrontNode& node) {
  return node.active && (node.prev < 0) != (node.next < 0);
}

ChainEnds::ChainEnds(const LayerState& state) : state_(state) {
  const auto& nodes = state.front.nodes();
  if (std::none_of(nodes.begin(), nodes.end(), is_chain_end)) return;
  for (const FrontNode& node : nodes) on_front_.push_back(node.vertex);
  std::sort(on_front_.begin(), on_front_.end());
}

// Length free along the boundary, up to `most`: a corner of the CAD or another front ends it.
double ChainEnds::room_along(VertexH from, bool forward, double most) const {
  const SurfaceMesh& mesh = state_.mesh;
  BorderWalk walk(mesh, from, forward);
  double length = 0.0;
  while (length < most) {
    const Vec3 step = walk.step();
    length += step.norm();
    walk.advance();
    const bool taken = mesh.data(walk.at()).layer > 0;
    if (taken || std::binary_search(on_front_.begin(), on_front_.end(), walk.at())) break;
    if (mesh.data(walk.at()).support != Support::kVertex) continue;
    const Vec3 onward = walk.step();
    if (step.dot(onward) < kCornerCosine * step.norm() * onward.norm()) break;
  }
  return length;
}

EndStep ChainEnds::step(int node, double height, bool follows) const {
  const SurfaceMesh& mesh = state_.mesh;
  const FrontNode& end = state_.front[node];
  EndStep step;
  if (!mesh.is_border(end.vertex)) return step;
  const bool forward = end.next < 0;
  const BorderWalk walk(mesh, end.vertex, forward);
  const VertexH beside = state_.front[forward ? end.prev : end.next].vertex;
  const Vec3 along = walk.step(), front = mesh.position(beside) - mesh.position(end.vertex);
  const Vec3& normal = mesh.data(end.vertex).normal;
  const double angle =
      forward ? turn_angle(along, front, normal) : turn_angle(front, along, normal);
  step.kid = end.vertex;
  step.height = height;
  step.lag = end.lag + height;
  if (!layers_run_along(angle, kChordSlack)) return step;
  const double most = end.lag + kHeightsSeen * height;
  const double room = room_along(end.vertex, forward, most) - end.lag;
  const double ahead = room * std::sin(angle);
  step.height = follows && ahead > kLeastRoom * height ? height : height_in_gap(height, ahead);
  step.lag = end.lag + step.height / std::sin(angle);
  const double distance = along.norm();
  if (step.height > 0.0 && step.lag > kSlide * distance && distance < room + end.lag) {
    step.kid = walk.next();
    step.lag -= distance;
  }
  return step;
}

void ChainEnds::join_facing(LayerState& state) {
  Front& front = state.front;
  std::unordered_map<VertexH, int> starts;
  for (int i = 0; i < front.size(); ++i) {
    if (is_chain_end(front[i]) && front[i].prev < 0) starts.emplace(front[i].vertex, i);
  }
  for (int i = 0; i < front.size() && !starts.empty(); ++i) {
    if (!is_chain_end(front[i]) || front[i].next >= 0) continue;
    if (!state.mesh.is_border(front[i].vertex)) continue;
    const BorderWalk walk(state.mesh, front[i].vertex, true);
    const auto facing = starts.find(walk.next());
    if (facing == starts.end()) continue;
    const int k = facing->second;
    const double gap = walk.step().norm();
    if (height_in_gap(std::min(front[i].growth.height, front[k].growth.height), gap) > 0.0)
      continue;
    front[i].next = k;
    front[k].prev = i;
  }
}

}  // namespace advlayers
