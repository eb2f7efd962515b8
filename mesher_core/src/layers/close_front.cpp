#include "layers/close_front.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "layers/recover.h"

namespace advlayers {
namespace {

constexpr double kDegree = M_PI / 180.0;
// Halving a sharper corner would leave angles below 20 degrees: it is closed by a triangle instead.
constexpr double kTipAngle = 40.0 * kDegree;
// The end of a gap is zipped where two more rows do not fit.
constexpr double kZipHeights = 2.0;
constexpr double kLeastQuadAngle = 35.0 * kDegree;
constexpr double kLargestQuadAngle = 145.0 * kDegree;
constexpr double kLeastTipAngle = 8.0 * kDegree;
// A region that an event closes holds few core triangles; more means that it is no narrow end.
constexpr std::size_t kMostFaces = 400;

class Closer {
 public:
  explicit Closer(LayerState& state) : state_(state), mesh_(state.mesh), front_(state.front) {}

  void run() {
    for (int i = 0; i < front_.size(); ++i) queue_.push_back(i);
    while (!queue_.empty()) {
      state_.cancel->check();
      const int i = queue_.front();
      queue_.pop_front();
      if (!front_[i].active || front_[i].next < 0 || front_[i].prev < 0) continue;
      if (close_small_ring(i) || close_tip(i) || zip_end(i)) continue;
    }
  }

 private:
  Corner at(int i) const { return corner(mesh_, front_[i].vertex); }
  double distance(int i, int k) const { return (at(i).xyz - at(k).xyz).norm(); }

  // Angle at b between a and c, measured from c counter-clockwise to a: inside the polygon a, b, c.
  double inner_angle(int a, int b, int c) const {
    const Corner corner_b = at(b);
    return turn_angle(at(c).xyz - corner_b.xyz, at(a).xyz - corner_b.xyz, corner_b.normal);
  }
  bool good_quad(int a, int b, int c, int d) const {
    for (const double angle :
         {inner_angle(d, a, b), inner_angle(a, b, c), inner_angle(b, c, d), inner_angle(c, d, a)}) {
      if (angle < kLeastQuadAngle || angle > kLargestQuadAngle) return false;
    }
    return true;
  }

  // Forces the edge from node a to node b, empties what lies right of it down to `faces` triangles
  // and takes them out of the core. The region is bounded by the front from a to b.
  bool cut_off(int a, int b, std::size_t faces) {
    const HalfedgeH cut = recover_edge(mesh_, front_[a].vertex, front_[b].vertex, state_.limits,
                                       state_.report->vetoes);
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
        clear_region(mesh_, h, kMostFaces, state_.limits, state_.report->vetoes);
    if (region.size() != faces) return false;
    if (faces == 1) {
      ++state_.report->triangles;
    } else {
      HalfedgeH e = mesh_.halfedge(region[0]);
      while (mesh_.frozen(e)) e = mesh_.next(e);
      if (mesh_.combine_veto(e) != Veto::kNone) return false;
      mesh_.combine(e);
      ++state_.report->quads;
    }
    return true;
  }

  // A ring of three or four nodes is one element.
  bool close_small_ring(int i) {
    const int n = front_.ring_size(i);
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
    if (shape.angle > kTipAngle) return false;
    const int b = front_[a].prev, c = front_[a].next;
    if (b == c || front_.ring_size(a) <= 4) return false;
    const double ratio = shape.length_prev / shape.length_next;
    if (ratio < 0.5 || ratio > 2.0) return false;
    if (min_angle(at(b), at(a), at(c)) < kLeastTipAngle) return false;
    if (!cut_off(b, c, 1)) return false;
    state_.count_event(Event::kCloseTriangle);
    state_.note_stop(a, Stop::kClosed);
    front_.bridge(b, c);
    again_about(b, c);
    return true;
  }

  //   b' --- c'     the front runs b', b, c, c'; the gap b - c is too narrow for two more rows:
  //   |       |     one quad closes it, and the front runs b', c'
  //   b ---- c
  bool zip_end(int b) {
    const int c = front_[b].next;
    if (front_[c].next < 0) return false;
    const int before = front_[b].prev, after = front_[c].next;
    if (before == after || before == c || front_.ring_size(b) <= 4) return false;
    const double height = 0.5 * (front_[before].height + front_[after].height);
    const double gap = std::min(distance(b, c), distance(before, after));
    if (gap > kZipHeights * height) return false;
    if (!good_quad(before, b, c, after)) return false;
    if (!cut_off(before, after, 2)) return false;
    state_.count_event(Event::kZip);
    state_.note_stop(b, Stop::kCollision);
    state_.note_stop(c, Stop::kCollision);
    front_.bridge(before, after);
    again_about(before, after);
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
