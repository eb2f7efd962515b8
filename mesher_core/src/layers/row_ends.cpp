#include "layers/row_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/angles.h"

namespace advlayers {
namespace {

constexpr double kLeastRowEndAngle = 30.0 * kDegree;  // and its supplement at most
constexpr double kNeighbourTurn = 40.0 * kDegree;  // beside a corner the front is nearly straight
constexpr double kRowEndHeights = 2.5;             // its quad is no higher than this many heights

class RowEnder {
 public:
  explicit RowEnder(PlanDraft& draft) : draft_(draft) {}

  void run() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      if (draft_.advances(i)) try_row_end(i);
    }
  }

 private:
  // May the front end a row at corner a: it turns enough, and its edges are short enough that one
  // more layer with a kid of its own would leave none worth keeping.
  bool ends_row(int a) const {
    if (!draft_.advances(a) || draft_.front[a].prev < 0 || draft_.front[a].next < 0) return false;
    if (!draft_.kids_of(a).empty()) return false;
    const NodeShape& s = draft_.shape(a);
    if (corner_class(s.angle) > CornerClass::kEnd) return false;
    const double height = draft_.height(a);
    if (std::max(s.length_next, s.length_prev) > kRowEndHeights * height) return false;
    const double eaten = height / std::tan(0.5 * s.angle);
    return s.shorter() - eaten <= 1.1 * draft_.front[a].growth.ratio * height;
  }
  // Is the node beside a row end free, and the front nearly straight there.
  bool runs_straight(int k) const {
    return k >= 0 && draft_.advances(k) && draft_.kids_of(k).empty() && draft_.front[k].prev >= 0 &&
           draft_.front[k].next >= 0 && std::abs(draft_.shape(k).turn()) <= kNeighbourTurn;
  }

  //   c ------ kid     A row end: the corner a and both its neighbours share the kid b + c - a.
  //   |         |      One quad, no triangle, two front edges less.
  //   a ------- b      (front: b, a, c)
  void try_row_end(int a) {
    if (!ends_row(a)) return;
    const int b = draft_.front[a].prev, c = draft_.front[a].next;
    if (draft_.front.ring_size(a, 6) >= 0) return;
    if (try_strip_end(a, c, draft_.front[c].next) || try_strip_end(draft_.front[b].prev, b, a))
      return;
    if (!runs_straight(b) || !runs_straight(c)) return;
    share_kid({a}, {b, c}, draft_.position(b) + draft_.position(c) - draft_.position(a));
  }

  //   b --- kid --- e     A strip two edges wide ends: two row ends share the node m between their
  //   |      |      |     corners, and the kid.
  //   a ---- m ---- d     (front: b, a, m, d, e)
  bool try_strip_end(int a, int m, int d) {
    if (a < 0 || d < 0 || !ends_row(a) || !ends_row(d) || !runs_straight(m)) return false;
    const int b = draft_.front[a].prev, e = draft_.front[d].next;
    if (!runs_straight(b) || !runs_straight(e) || b == e || draft_.front[b].prev == e) return false;
    const Vec3 side =
        0.5 * (draft_.position(b) - draft_.position(a) + draft_.position(e) - draft_.position(d));
    return share_kid({a, d}, {b, m, e}, draft_.position(m) + side);
  }

  // One kid for all `parents`; the corners in between get none.
  bool share_kid(const std::vector<int>& corners, const std::vector<int>& parents,
                 const Vec3& xyz) {
    SurfacePoint point;
    if (!draft_.state.surface.project(xyz, draft_.mesh.data(draft_.front[parents[0]].vertex).point,
                                      point))
      return false;
    const Corner kid_at{point.xyz, draft_.state.surface.normal(point)};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Corner p = corner(draft_.mesh, draft_.front[parents[k]].vertex);
      const Corner q = corner(draft_.mesh, draft_.front[parents[k + 1]].vertex);
      const Corner a = corner(draft_.mesh, draft_.front[corners[k]].vertex);
      const double least = std::min({min_angle(p, a, q), min_angle(a, q, kid_at),
                                     min_angle(q, kid_at, p), min_angle(kid_at, p, a)});
      if (least <= 0.0) return false;
      for (const auto& [x, y, z] : {std::array{p, a, q}, std::array{a, q, kid_at},
                                    std::array{q, kid_at, p}, std::array{kid_at, p, a}}) {
        const double angle = inner_angle(x, y, z);
        if (angle < kLeastRowEndAngle || angle > M_PI - kLeastRowEndAngle) return false;
      }
    }
    // Of three parents the middle one: its edge to the kid bounds both quads.
    const std::size_t first = (parents.size() - 1) / 2;
    const int kid = draft_.add_kid(parents[first], point);
    draft_.kid(kid).parents = parents;
    double height = 0.0;
    Growth& shared = draft_.kid(kid).growth;
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const Growth next = draft_.front[parents[k]].growth.next();
      height += next.height / static_cast<double>(parents.size());
      shared.layers_left = std::min(shared.layers_left, next.layers_left);
      draft_.kids_of(parents[k]) = {kid};
      if (k != first) draft_.state.note_stop(parents[k], Stop::kMerged);
    }
    shared.height = height;
    for (const int a : corners) {
      draft_.kids_of(a) = {kid};
      draft_.state.note_stop(a, Stop::kClosed);
      draft_.state.count_event(Event::kRowEnd);
    }
    return true;
  }

  PlanDraft& draft_;
};

}  // namespace

void end_rows(PlanDraft& draft) { RowEnder(draft).run(); }

}  // namespace advlayers
