#include "layers/close_front.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/angles.h"
#include "base/ties.h"
#include "layers/concave_scaling.h"
#include "layers/front_index.h"
#include "layers/recover.h"

namespace advlayers {
namespace {

// At the head of a narrow strip a corner is closed by a triangle up to this, to begin zipping.
constexpr double kStripTipAngle = 80.0 * kDegree;
// The end of a gap is zipped, and a gap bridged, where two more rows hardly fit: the paper's 2.4.
constexpr double kZipHeights = 2.4;
constexpr double kLeastEndAngle = 55.0 * kDegree;     // at the two corners of a strip's end
constexpr double kLargestEndAngle = 125.0 * kDegree;  // the same
constexpr double kTipTurn = 60.0 * kDegree;  // of a convex corner that runs ahead of the front
// Between a rung, or a bridging triangle's side, and the front's edges beside it.
constexpr double kLeastRungAngle = 45.0 * kDegree;
constexpr double kLeastQuadAngle = 35.0 * kDegree;
constexpr double kLargestQuadAngle = 145.0 * kDegree;
constexpr double kLeastTipAngle = 8.0 * kDegree;
// A corner of the CAD has the angle that it has: any other cells there would be thinner still.
constexpr double kLeastCadTipAngle = 0.05 * kDegree;
constexpr double kLeastTriangleAngle = 15.0 * kDegree;  // of one across a gap
// A region that an event closes holds few core triangles; more means that it is no narrow end.
constexpr std::size_t kMostFaces = 400;

class Closer {
 public:
  explicit Closer(LayerState& state) : state_(state), mesh_(state.mesh), front_(state.front) {}

  void run() {
    for (int i = 0; i < front_.size(); ++i) queue_.push_back(i);
    close_queued();
    bridge_gaps();
  }

 private:
  void close_queued() {
    while (!queue_.empty()) {
      state_.context.check();
      const int i = queue_.front();
      queue_.pop_front();
      if (!front_[i].active || front_[i].next < 0 || front_[i].prev < 0) continue;
      if (close_small_ring(i) || (state_.steps.tips && close_tip(i))) continue;
      if (state_.steps.zips) zip_end(i);
    }
  }

  struct Gap {
    double distance;  // [mm]
    int node;
    VertexH from, to;  // of the opposing edge
  };

  // Where two fronts come too near for two more rows, a rung joins them at the narrowest place; the
  // gap's two halves then have ends, which are zipped.
  void bridge_gaps() {
    std::vector<Gap> gaps;
    {
      const FrontIndex fronts(mesh_, front_);
      for (int i = 0; i < front_.size(); ++i) {
        if (!front_[i].active || front_[i].next < 0 || front_[i].prev < 0) continue;
        FrontIndex::Hit hit;
        const NodeShape shape = node_shape(mesh_, front_, i);
        const double height = std::min(front_[i].growth.height, state_.max_height);
        const double factor = concave_factor(shape, height);
        // Two rows, ours and the opposing one; a convex corner is joined one row earlier, while
        // there is room to reach both ends of the edge that it runs into.
        const double rows = 1.0 + factor + (shape.turn() < -kTipTurn ? 1.0 : 0.0);
        const double reach = rows * height;
        if (!fronts.nearest_ahead(i, shape, reach, hit)) continue;
        gaps.push_back({settled(hit.distance), i, hit.from, hit.to});
      }
    }
    std::sort(gaps.begin(), gaps.end(), [](const Gap& a, const Gap& b) {
      return a.distance != b.distance ? a.distance < b.distance : a.node < b.node;
    });
    for (const Gap& gap : gaps) {
      state_.context.check();
      if (!front_[gap.node].active) continue;
      if ((state_.steps.rungs && place_rung(gap)) ||
          (state_.steps.bridges && place_triangle(gap))) {
        close_queued();
      }
    }
  }

  int active_node_at(VertexH v) const {
    for (int i = 0; i < front_.size(); ++i) {
      const FrontNode& node = front_[i];
      if (node.vertex == v && node.active && node.prev >= 0 && node.next >= 0) return i;
    }
    return -1;
  }

  //   --- q2 q1 ---      The front ran from the left through p to the right, and back through q; it
  //        | |           now turns at the rung: prev(p), p1, q1, next(q) and prev(q), q2, p2,
  //        next(p).
  //   --- p1 p2 ---      (p1 and q2 are the old nodes)
  bool place_rung(const Gap& gap) {
    const int p = gap.node;
    if (front_[p].prev < 0 || front_[p].next < 0) return false;
    int q = -1;
    double best = kLeastRungAngle;
    for (const VertexH v : {gap.from, gap.to}) {
      const int k = active_node_at(v);
      if (k < 0 || k == p || k == front_[p].next || k == front_[p].prev) continue;
      const double angle =
          settled(std::min({angle_at(front_[p].prev, p, k), angle_at(k, p, front_[p].next),
                            angle_at(front_[k].prev, k, p), angle_at(p, k, front_[k].next)}));
      if (angle > best) {
        best = angle;
        q = k;
      }
    }
    if (q < 0 ||
        distance(p, q) > std::max(kZipHeights * front_[p].growth.height, 1.2 * gap.distance)) {
      return false;
    }
    if (!freeze_between(p, q).valid()) return false;
    front_.split_at_rung(p, q);
    state_.count_event(Event::kRung);
    for (const int k : {p, q, front_[p].next, front_[q].next}) queue_.push_back(k);
    for (const int k : {front_[p].prev, front_[q].prev}) queue_.push_back(k);
    return true;
  }

  //   -- q2 --- q --      No node faces p: one triangle joins it to the edge, and the front turns
  //   at
  //       \    /           both its sides: prev(p), p, q2 and q, p', next(p).
  //        \  /
  //   ----- p -----
  bool place_triangle(const Gap& gap) {
    const int p = gap.node;
    if (front_[p].prev < 0 || front_[p].next < 0) return false;
    const int q = active_node_at(gap.from);
    if (q < 0 || front_[q].next < 0 || front_[front_[q].next].vertex != gap.to) return false;
    const int after = front_[q].next;
    if (front_[after].next < 0) return false;
    for (const int near : {p, front_[p].prev, front_[p].next}) {
      if (near == q || near == after) return false;
    }
    if (min_angle(at(q), at(after), at(p)) < kLeastTriangleAngle) return false;
    for (const double angle :
         {angle_at(front_[p].prev, p, after), angle_at(q, p, front_[p].next),
          angle_at(front_[q].prev, q, p), angle_at(p, after, front_[after].next)}) {
      if (angle < kLeastRungAngle) return false;
    }
    const HalfedgeH left = freeze_between(p, q);
    if (!left.valid()) return false;
    const HalfedgeH right = freeze_between(p, after);
    if (!right.valid() || !take(front_edge(q), 1)) {
      mesh_.set_frozen(left, false);
      if (right.valid()) mesh_.set_frozen(right, false);
      return false;
    }
    front_.split_at_triangle(p, q);
    state_.count_event(Event::kBridge);
    for (const int k : {p, q, after, front_[q].next}) queue_.push_back(k);
    for (const int k : {front_[p].prev, front_[q].prev}) queue_.push_back(k);
    return true;
  }
  // The edge between two nodes, recovered and frozen; invalid where that fails or it was frozen.
  HalfedgeH freeze_between(int i, int k) {
    const HalfedgeH h = recover_edge(mesh_, front_[i].vertex, front_[k].vertex, state_.limits,
                                     state_.report.vetoes);
    if (!h.valid() || mesh_.frozen(h)) return {};
    mesh_.set_frozen(h, true);
    return h;
  }

  Corner at(int i) const { return corner(mesh_, front_[i].vertex); }
  double distance(int i, int k) const { return (at(i).xyz - at(k).xyz).norm(); }

  double angle_at(int a, int b, int c) const { return inner_angle(at(a), at(b), at(c)); }
  bool good_quad(int a, int b, int c, int d) const {
    for (const double angle :
         {angle_at(d, a, b), angle_at(a, b, c), angle_at(b, c, d), angle_at(c, d, a)}) {
      if (angle < kLeastQuadAngle || angle > kLargestQuadAngle) return false;
    }
    return true;
  }

  // Forces the edge from node a to node b, empties what lies right of it down to `faces` triangles
  // and takes them out of the core. The region is bounded by the front from a to b.
  bool cut_off(int a, int b, std::size_t faces) {
    const HalfedgeH cut = recover_edge(mesh_, front_[a].vertex, front_[b].vertex, state_.limits,
                                       state_.report.vetoes);
    if (!cut.valid()) return false;
    const bool was_frozen = mesh_.frozen(cut);
    mesh_.set_frozen(cut, true);
    if (!take(front_edge(a), faces)) {
      mesh_.set_frozen(cut, was_frozen);
      return false;
    }
    return true;
  }
  HalfedgeH front_edge(int i) const {
    return mesh_.find_halfedge(front_[i].vertex, front_[front_[i].next].vertex);
  }
  // Closes the region left of a front edge as `faces` triangles, a quad where they are two.
  bool take(HalfedgeH h, std::size_t faces) {
    const std::vector<FaceH> region =
        clear_region(mesh_, h, kMostFaces, state_.limits, state_.report.vetoes);
    if (region.size() != faces) return false;
    if (faces == 1) {
      ++state_.report.triangles;
    } else {
      HalfedgeH e = mesh_.halfedge(region[0]);
      while (mesh_.frozen(e)) e = mesh_.next(e);
      if (mesh_.combine_veto(e) != Veto::kNone) return false;
      mesh_.combine(e);
      ++state_.report.quads;
    }
    return true;
  }

  // A ring of three or four nodes is one element.
  bool close_small_ring(int i) {
    const int n = front_.ring_size(i, 4);
    if (n != 3 && n != 4) return false;
    const int b = front_[i].next, c = front_[b].next, d = front_[c].next;
    if (n == 4 && !good_quad(i, b, c, d)) return false;
    if (!take(front_edge(i), n == 3 ? 1 : 2)) return false;
    state_.count_event(Event::kZip);
    for (const int k : {i, b, c, d}) {
      if (front_[k].active) retire(k, Stop::kClosed);
    }
    return true;
  }
  void retire(int k, Stop reason) {
    state_.note_stop(k, reason);
    front_[k].active = false;
  }

  // A corner sharper than 40 degrees becomes one triangle; the front goes straight across.
  bool close_tip(int a) {
    const NodeShape shape = node_shape(mesh_, front_, a);
    const int b = front_[a].prev, c = front_[a].next;
    if (b == c || front_.ring_size(a, 4) >= 0) return false;
    const bool tip = corner_class(shape.angle) == CornerClass::kTip;
    if (!tip && (shape.angle > kStripTipAngle || !heads_strip(a))) return false;
    const double ratio = shape.length_prev / shape.length_next;
    if (ratio < 0.5 || ratio > 2.0) return false;
    const bool of_cad = mesh_.data(front_[a].vertex).support == Support::kVertex;
    const double least = of_cad ? kLeastCadTipAngle : kLeastTipAngle;
    if (min_angle(at(b), at(a), at(c)) < least) return false;
    if (!cut_off(b, c, 1)) return false;
    state_.count_event(Event::kCloseTriangle);
    state_.note_stop(a, Stop::kClosed);
    front_.bridge(b, c);
    again_about(b, c);
    return true;
  }

  // Does a narrow strip begin at the tip a: the next two pairs of nodes are both too near for rows.
  bool heads_strip(int a) const {
    const int b = front_[a].prev, c = front_[a].next;
    const int before = front_[b].prev, after = front_[c].next;
    if (before < 0 || after < 0 || before == after) return false;
    const double reach = kZipHeights * std::min(front_[a].growth.height, state_.max_height);
    return distance(b, c) <= reach && distance(before, after) <= reach;
  }

  //   b' --- c'     the front runs b', b, c, c'; the gap b - c is too narrow for two more rows:
  //   |       |     one quad closes it, and the front runs b', c'
  //   b ---- c
  bool zip_end(int b) {
    const int c = front_[b].next;
    if (front_[c].next < 0) return false;
    const int before = front_[b].prev, after = front_[c].next;
    if (before == after || before == c || front_.ring_size(b, 4) >= 0) return false;
    const double height = 0.5 * (front_[before].growth.height + front_[after].growth.height);
    if (distance(b, c) > kZipHeights * height) return false;
    if (!square_end(b, c) || !good_quad(before, b, c, after)) return false;
    if (!cut_off(before, after, 2)) return false;
    state_.count_event(Event::kZip);
    state_.note_stop(b, Stop::kCollision);
    state_.note_stop(c, Stop::kCollision);
    front_.bridge(before, after);
    again_about(before, after);
    return true;
  }
  bool square_end(int b, int c) const {
    for (const int k : {b, c}) {
      const double angle = node_shape(mesh_, front_, k).angle;
      if (angle < kLeastEndAngle || angle > kLargestEndAngle) return false;
    }
    return true;
  }

  void again_about(int a, int b) {
    for (const int k : {a, b, front_[a].prev, front_[b].next}) {
      if (k >= 0) queue_.push_back(k);
    }
  }

  LayerState& state_;
  SurfaceMesh& mesh_;
  Front& front_;
  std::deque<int> queue_;
};

}  // namespace

void close_front(LayerState& state) { Closer(state).run(); }

}  // namespace advlayers
