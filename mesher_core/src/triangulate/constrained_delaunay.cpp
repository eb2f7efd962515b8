#include "triangulate/constrained_delaunay.h"

#include <cmath>
#include <deque>
#include <limits>
#include <string>

#include "base/predicates.h"
#include "triangulate/hilbert_order.h"

namespace advlayers {
namespace {

constexpr std::size_t kCancelStride = 1024;  // insertions between two looks at the flag
constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

}  // namespace

ConstrainedDelaunay::ConstrainedDelaunay(const RunContext& context,
                                         const std::vector<Vec2>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) {
      throw InvalidInput("point {} of a triangulation is not finite", i);
    }
    mesh_.add_point(points[i]);
  }
  alias_.assign(points.size(), -1);
  add_box(points);
  std::size_t since_check = 0;
  int hint = 0;
  for (const int v : hilbert_order(context, points)) {
    if (++since_check % kCancelStride == 0) context.check();
    hint = insert(v, hint);
  }
  visited_.clear();
}

// Two triangles over a box three times as large as the points: corners n .. n + 3.
void ConstrainedDelaunay::add_box(const std::vector<Vec2>& points) {
  Vec2 low = points.empty() ? Vec2(0, 0) : points.front(), high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  const double margin = extent > 0 ? extent : std::max(1.0, high.cwiseAbs().maxCoeff());
  const int a = mesh_.add_point(low - Vec2(margin, margin));
  const int b = mesh_.add_point(Vec2(high.x() + margin, low.y() - margin));
  const int c = mesh_.add_point(high + Vec2(margin, margin));
  const int d = mesh_.add_point(Vec2(low.x() - margin, high.y() + margin));
  const int first = mesh_.add_triangle(a, b, c), second = mesh_.add_triangle(a, c, d);
  mesh_.join({first, 1}, {second, 2});
}

ConstrainedDelaunay::Location ConstrainedDelaunay::classify(int t, const Vec2& p) const {
  int zero_count = 0, zero_sum = 0, zero_side = -1;
  for (int i = 0; i < 3; ++i) {
    const int turn = orient2d(mesh_.point(mesh_.from({t, i})), mesh_.point(mesh_.to({t, i})), p);
    if (turn < 0) return {-1};
    if (turn > 0) continue;
    ++zero_count;
    zero_sum += i;
    zero_side = i;
  }
  // On two sides at once: on the corner between them, whose index is that of the third side.
  if (zero_count == 2) return {t, mesh_.triangle(t).v[3 - zero_sum], -1};
  return {t, -1, zero_side};
}

// Walks from triangle to triangle towards p. No triangle is entered twice, so that the walk ends;
// where it is stuck, all triangles are searched.
ConstrainedDelaunay::Location ConstrainedDelaunay::locate(const Vec2& p, int hint) {
  visited_.resize(mesh_.triangles().size(), 0);
  ++stamp_;
  int t = hint;
  while (t >= 0) {
    visited_[static_cast<std::size_t>(t)] = stamp_;
    int next = -1;
    bool inside = true;
    for (int i = 0; i < 3 && next < 0; ++i) {
      const int n = mesh_.triangle(t).n[i];
      if (n >= 0 && visited_[static_cast<std::size_t>(n)] == stamp_) continue;
      if (orient2d(mesh_.point(mesh_.from({t, i})), mesh_.point(mesh_.to({t, i})), p) >= 0)
        continue;
      inside = false;
      next = n;
    }
    if (inside) {
      const Location found = classify(t, p);
      if (found.t >= 0) return found;
    }
    t = next;
  }
  for (int k = 0; k < mesh_.triangle_count(); ++k) {
    const Location found = classify(k, p);
    if (found.t >= 0) return found;
  }
  throw InternalError("a point lies outside of the triangulation's box");
}

bool ConstrainedDelaunay::wants_flip(Side s) const {
  const Side o = mesh_.opposite(s);
  return surely_in_circle(mesh_.point(mesh_.from(s)), mesh_.point(mesh_.to(s)),
                          mesh_.point(mesh_.apex(s)), mesh_.point(mesh_.apex(o)));
}

// Inserts point v and returns a triangle near it, for the next walk to start in.
int ConstrainedDelaunay::insert(int v, int hint) {
  const Location at = locate(mesh_.point(v), hint);
  if (at.vertex >= 0) {
    alias_[static_cast<std::size_t>(v)] = at.vertex;
    return at.t;
  }
  alias_[static_cast<std::size_t>(v)] = v;
  if (at.side >= 0) {
    mesh_.split_side({at.t, at.side}, v);
  } else {
    mesh_.split_triangle(at.t, v);
  }
  pending_.clear();
  mesh_.append_link(v, pending_);
  // After a flip both triangles have v as corner 0: only the sides opposite it can have become bad.
  while (!pending_.empty()) {
    const Side s = pending_.back();
    pending_.pop_back();
    const int other = mesh_.triangle(s.t).n[s.i];
    if (other < 0 || !wants_flip(s)) continue;
    mesh_.flip(s);
    pending_.push_back({s.t, 0});
    pending_.push_back({other, 0});
  }
  return mesh_.triangle_of(v);
}

// The edges between a and b, as far as the next vertex on the straight line between them.
ConstrainedDelaunay::Path ConstrainedDelaunay::path(int a, int b) const {
  const Vec2 &pa = mesh_.point(a), &pb = mesh_.point(b);
  const auto turn = [&](int v) { return orient2d(pa, pb, mesh_.point(v)); };
  Path way;
  std::vector<Side> link;
  mesh_.append_link(a, link);
  Side s;
  for (const Side& side : link) {
    const int right = mesh_.from(side), left = mesh_.to(side);
    for (const int end : {right, left}) {
      if (end == b || (turn(end) == 0 && (mesh_.point(end) - pa).dot(pb - pa) > 0)) {
        way.end = end;
        return way;
      }
    }
    if (turn(right) < 0 && turn(left) > 0) s = side;
  }
  while (s.t >= 0) {
    const int right = mesh_.from(s), left = mesh_.to(s);
    if (mesh_.segment(s) >= 0) {
      way.blocked = constraints_[static_cast<std::size_t>(mesh_.segment(s))].mark;
      return way;
    }
    way.crossed.push_back({right, left});
    const Side o = mesh_.opposite(s);
    if (o.t < 0) break;
    const int apex = mesh_.apex(o);
    const int side_of_apex = apex == b ? 0 : turn(apex);
    if (side_of_apex == 0) {
      way.end = apex;
      return way;
    }
    // From the far triangle's view the edge runs left -> right; leave it opposite the end on
    // the apex's side.
    s = {o.t, side_of_apex > 0 ? PlanarTriangulation::ccw(o.i) : PlanarTriangulation::cw(o.i)};
  }
  throw InternalError("a segment leaves the triangulation's box");
}

// Flips the crossed edges away; those that no quad lets go yet wait for their neighbours.
void ConstrainedDelaunay::recover(int a, int b, const std::vector<std::array<int, 2>>& crossed) {
  const Vec2 &pa = mesh_.point(a), &pb = mesh_.point(b);
  std::deque<std::array<int, 2>> queue(crossed.begin(), crossed.end());
  std::vector<std::array<int, 2>> fresh;
  std::size_t refused = 0;
  while (!queue.empty()) {
    const auto [right, left] = queue.front();
    queue.pop_front();
    const Side s = mesh_.find_side(right, left);
    if (!mesh_.flippable(s)) {
      queue.push_back({right, left});
      if (++refused > queue.size() + 1) throw InternalError("a segment cannot be recovered");
      continue;
    }
    refused = 0;
    const int c = mesh_.apex(s), d = mesh_.apex(mesh_.opposite(s));
    mesh_.flip(s);
    const int turn_c = orient2d(pa, pb, mesh_.point(c)), turn_d = orient2d(pa, pb, mesh_.point(d));
    if (turn_c * turn_d < 0) {
      queue.push_back(turn_c < 0 ? std::array<int, 2>{c, d} : std::array<int, 2>{d, c});
    } else {
      fresh.push_back({c, d});
    }
  }
  const Side recovered = mesh_.find_side(a, b);
  mesh_.set_segment(recovered, 0);  // shields it from the flips below; named by mark_edge
  pending_.clear();
  for (const auto& [c, d] : fresh) {
    const Side s = mesh_.find_side(c, d);
    if (s.t >= 0) pending_.push_back(s);
  }
  mesh_.restore(pending_, kNoLimit, [this](Side s) { return wants_flip(s); });
  mesh_.set_segment(mesh_.find_side(a, b), -1);
}

void ConstrainedDelaunay::mark_edge(int a, int b, int mark, Conflict& conflict) {
  const Side s = mesh_.find_side(a, b);
  const int existing = mesh_.segment(s);
  if (existing >= 0) {
    Constraint& known = constraints_[static_cast<std::size_t>(existing)];
    known.net += known.from == a ? 1 : -1;
    conflict.overlaps = known.mark;
    return;
  }
  mesh_.set_segment(s, static_cast<int>(constraints_.size()));
  constraints_.push_back({a, b, mark, 1});
}

ConstrainedDelaunay::Conflict ConstrainedDelaunay::constrain(int a, int b, int mark) {
  Conflict conflict;
  for (int from = a; from != b;) {
    const Path way = path(from, b);
    if (way.blocked >= 0) {
      conflict.crossed = way.blocked;
      return conflict;
    }
    if (!way.crossed.empty()) recover(from, way.end, way.crossed);
    mark_edge(from, way.end, mark, conflict);
    if (way.end != b) conflict.through = way.end;
    from = way.end;
  }
  return conflict;
}

ConstrainedDelaunay::Windings ConstrainedDelaunay::carve(const RunContext& context) {
  constexpr int kUnknown = std::numeric_limits<int>::min();
  std::vector<int> winding(mesh_.triangles().size(), kUnknown);
  Windings range;
  // The corners of the box are the last four points; no segment lies beside the box itself.
  std::vector<int> stack{mesh_.triangle_of(mesh_.point_count() - 1)};
  winding[static_cast<std::size_t>(stack.front())] = 0;
  while (!stack.empty()) {
    const int t = stack.back();
    stack.pop_back();
    const int here = winding[static_cast<std::size_t>(t)];
    range.lowest = std::min(range.lowest, here);
    range.highest = std::max(range.highest, here);
    for (int i = 0; i < 3; ++i) {
      const int n = mesh_.triangle(t).n[i];
      if (n < 0 || winding[static_cast<std::size_t>(n)] != kUnknown) continue;
      int step = 0;
      if (const int segment = mesh_.segment({t, i}); segment >= 0) {
        const Constraint& c = constraints_[static_cast<std::size_t>(segment)];
        step = mesh_.from({t, i}) == c.from ? -c.net : c.net;
      }
      winding[static_cast<std::size_t>(n)] = here + step;
      stack.push_back(n);
    }
  }
  std::vector<char> kept(mesh_.triangles().size());
  for (std::size_t t = 0; t < kept.size(); ++t) kept[t] = winding[t] > 0;
  mesh_.keep(context, kept);
  for (int t = 0; t < mesh_.triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int segment = mesh_.segment({t, i});
      const int other = mesh_.triangle(t).n[i];
      if (segment < 0 || (other >= 0 && other < t)) continue;
      mesh_.set_segment({t, i}, constraints_[static_cast<std::size_t>(segment)].mark);
    }
  }
  return range;
}

}  // namespace advlayers
