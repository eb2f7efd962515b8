#include "triangulate/planar_triangulation.h"

#include <algorithm>

#include "base/predicates.h"

namespace advlayers {
namespace {

void turn_to_least_corner(PlanarTriangulation::Triangle& t) {
  const auto least = std::min_element(t.v.begin(), t.v.end()) - t.v.begin();
  for (std::array<int, 3>* ring : {&t.v, &t.n, &t.segment}) {
    std::rotate(ring->begin(), ring->begin() + least, ring->end());
  }
}

}  // namespace

int PlanarTriangulation::add_point(const Vec2& p) {
  points_.push_back(p);
  triangle_of_.push_back(-1);
  return point_count() - 1;
}

int PlanarTriangulation::add_triangle(int a, int b, int c) {
  triangles_.emplace_back();
  set_triangle(triangle_count() - 1, {a, b, c}, {-1, -1, -1}, {-1, -1, -1});
  return triangle_count() - 1;
}

void PlanarTriangulation::set_triangle(int t, std::array<int, 3> v, std::array<int, 3> n,
                                       std::array<int, 3> segment) {
  tri(t) = {v, n, segment};
  for (const int corner : v) triangle_of_[static_cast<std::size_t>(corner)] = t;
}

void PlanarTriangulation::join(Side a, Side b) {
  tri(a.t).n[a.i] = b.t;
  tri(b.t).n[b.i] = a.t;
}

void PlanarTriangulation::set_segment(Side s, int segment) {
  const Side other = opposite(s);
  tri(s.t).segment[s.i] = segment;
  if (other.t >= 0) tri(other.t).segment[other.i] = segment;
}

PlanarTriangulation::Side PlanarTriangulation::opposite(Side s) const {
  const int other = triangle(s.t).n[s.i];
  if (other < 0) return {};
  for (int i = 0; i < 3; ++i) {
    if (triangle(other).n[i] == s.t && triangle(other).v[ccw(i)] == to(s)) return {other, i};
  }
  return {};
}

PlanarTriangulation::Side PlanarTriangulation::find_side(int a, int b) const {
  const int first = triangle_of(a);
  // Turns about a, first counter-clockwise; from the border back again, clockwise.
  for (const bool forward : {true, false}) {
    int t = first;
    while (t >= 0) {
      const auto& corners = triangle(t).v;
      const int i = corners[0] == a ? 0 : corners[1] == a ? 1 : 2;
      if (corners[ccw(i)] == b) return {t, cw(i)};
      t = triangle(t).n[forward ? ccw(i) : cw(i)];
      if (t == first) return {};
    }
  }
  return {};
}

PlanarTriangulation::Side PlanarTriangulation::search_side(int a, int b) const {
  if (const Side found = find_side(a, b); found.t >= 0) return found;
  for (int t = 0; t < triangle_count(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (from({t, i}) == a && to({t, i}) == b) return {t, i};
    }
  }
  return {};
}

// The neighbour across side i of t has t for `old_neighbour` from now on.
void PlanarTriangulation::relink(int t, int i, int old_neighbour) {
  const int other = tri(t).n[i];
  if (other < 0 || old_neighbour == t) return;
  const int start = tri(t).v[ccw(i)];
  for (int k = 0; k < 3; ++k) {
    if (tri(other).n[k] == old_neighbour && tri(other).v[cw(k)] == start) tri(other).n[k] = t;
  }
}

bool PlanarTriangulation::flippable(Side s) const {
  const Side other = opposite(s);
  if (other.t < 0) return false;
  const Vec2 &a = point(from(s)), &b = point(to(s)), &c = point(apex(s)), &d = point(apex(other));
  return orient2d(c, a, d) > 0 && orient2d(d, b, c) > 0;
}

void PlanarTriangulation::flip(Side s) {
  const Side o = opposite(s);
  const Triangle p = tri(s.t), q = tri(o.t);
  const int a = p.v[ccw(s.i)], b = p.v[cw(s.i)], c = p.v[s.i], d = q.v[o.i];
  const int bc = ccw(s.i), ca = cw(s.i), ad = ccw(o.i), db = cw(o.i);
  set_triangle(o.t, {c, a, d}, {q.n[ad], s.t, p.n[ca]}, {q.segment[ad], -1, p.segment[ca]});
  set_triangle(s.t, {c, d, b}, {q.n[db], p.n[bc], o.t}, {q.segment[db], p.segment[bc], -1});
  relink(o.t, 2, s.t);
  relink(s.t, 0, o.t);
}

void PlanarTriangulation::split_triangle(int t, int v) {
  const Triangle old = tri(t);
  const int second = add_triangle(v, old.v[1], old.v[2]);
  const int third = add_triangle(v, old.v[2], old.v[0]);
  set_triangle(second, {v, old.v[1], old.v[2]}, {old.n[0], third, t}, {old.segment[0], -1, -1});
  set_triangle(third, {v, old.v[2], old.v[0]}, {old.n[1], t, second}, {old.segment[1], -1, -1});
  set_triangle(t, {v, old.v[0], old.v[1]}, {old.n[2], second, third}, {old.segment[2], -1, -1});
  relink(second, 0, t);
  relink(third, 0, t);
}

bool PlanarTriangulation::splittable(Side s, const Vec2& p) const {
  const auto halves_turn_left = [&](Side side) {
    const Vec2 &a = point(from(side)), &b = point(to(side)), &c = point(apex(side));
    return orient2d(p, b, c) > 0 && orient2d(p, c, a) > 0;
  };
  const Side other = opposite(s);
  return halves_turn_left(s) && (other.t < 0 || halves_turn_left(other));
}

void PlanarTriangulation::split_side(Side s, int v) {
  const Side o = opposite(s);
  const Triangle p = tri(s.t);
  const int a = p.v[ccw(s.i)], b = p.v[cw(s.i)], c = p.v[s.i], mark = p.segment[s.i];
  const int bc = ccw(s.i), ca = cw(s.i);
  const int p2 = add_triangle(v, b, c);
  set_triangle(p2, {v, b, c}, {p.n[bc], s.t, -1}, {p.segment[bc], -1, mark});
  set_triangle(s.t, {v, c, a}, {p.n[ca], -1, p2}, {p.segment[ca], mark, -1});
  relink(p2, 0, s.t);
  if (o.t < 0) return;
  const Triangle q = tri(o.t);
  const int d = q.v[o.i], ad = ccw(o.i), db = cw(o.i);
  const int q2 = add_triangle(v, d, b);
  set_triangle(q2, {v, d, b}, {q.n[db], p2, o.t}, {q.segment[db], mark, -1});
  set_triangle(o.t, {v, a, d}, {q.n[ad], q2, s.t}, {q.segment[ad], -1, mark});
  relink(q2, 0, o.t);
  tri(p2).n[2] = q2;
  tri(s.t).n[1] = o.t;
}

void PlanarTriangulation::keep(const RunContext& context, const std::vector<char>& kept) {
  std::vector<int> order;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    if (!kept[t]) continue;
    turn_to_least_corner(triangles_[t]);
    order.push_back(static_cast<int>(t));
  }
  std::sort(order.begin(), order.end(), [&](int s, int t) {
    context.check();
    return triangle(s).v < triangle(t).v;
  });
  std::vector<int> renumbered(triangles_.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    renumbered[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  }
  const std::vector<Triangle> before = std::move(triangles_);
  triangles_.resize(order.size());
  triangle_of_.assign(points_.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    Triangle moved = before[static_cast<std::size_t>(order[k])];
    for (int& n : moved.n) n = n < 0 ? -1 : renumbered[static_cast<std::size_t>(n)];
    set_triangle(static_cast<int>(k), moved.v, moved.n, moved.segment);
  }
}

void PlanarTriangulation::append_link(int v, std::vector<Side>& out) const {
  const int first = triangle_of(v);
  for (const bool forward : {true, false}) {
    int t = first;
    while (t >= 0) {
      const auto& corners = triangle(t).v;
      const int i = corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
      if (forward || t != first) out.push_back({t, i});
      t = triangle(t).n[forward ? ccw(i) : cw(i)];
      if (t == first) return;
    }
  }
}

}  // namespace advlayers
