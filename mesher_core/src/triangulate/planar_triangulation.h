// A triangulation in the plane: points, triangles with neighbours, and the local operations on
// them. Every triangle runs strictly counter-clockwise, by exact orientation, before and after each
// one.
#pragma once

#include <array>
#include <vector>

#include "base/run_context.h"
#include "base/types.h"

namespace advlayers {

class PlanarTriangulation {
 public:
  struct Triangle {
    std::array<int, 3> v;        // counter-clockwise
    std::array<int, 3> n;        // neighbour across the edge opposite v[i]; -1: none
    std::array<int, 3> segment;  // the constraint that edge belongs to; -1: none
  };
  // The edge of triangle t opposite its corner i, seen with t on its left.
  struct Side {
    int t = -1;
    int i = 0;
  };

  static constexpr int ccw(int i) { return i == 2 ? 0 : i + 1; }
  static constexpr int cw(int i) { return i == 0 ? 2 : i - 1; }

  const std::vector<Vec2>& points() const { return points_; }
  const Vec2& point(int v) const { return points_[static_cast<std::size_t>(v)]; }
  int point_count() const { return static_cast<int>(points_.size()); }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const Triangle& triangle(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  int triangle_count() const { return static_cast<int>(triangles_.size()); }
  // A triangle about v; -1 where v is in none.
  int triangle_of(int v) const { return triangle_of_[static_cast<std::size_t>(v)]; }

  int add_point(const Vec2& p);
  int add_triangle(int a, int b, int c);  // neighbours are joined by the caller
  void join(Side a, Side b);
  void set_segment(Side s, int segment);  // on both sides

  int from(Side s) const { return triangle(s.t).v[ccw(s.i)]; }
  int to(Side s) const { return triangle(s.t).v[cw(s.i)]; }
  int apex(Side s) const { return triangle(s.t).v[s.i]; }
  int segment(Side s) const { return triangle(s.t).segment[s.i]; }
  // The same edge from the other side; t is -1 where there is none.
  Side opposite(Side s) const;
  // The side a -> b, from among the triangles that hang together about a with triangle_of(a); t is
  // -1 where there is no such edge.
  Side find_side(int a, int b) const;
  // The same where the border may touch itself at a: looks at all triangles if need be.
  Side search_side(int a, int b) const;

  // Whether the two triangles beside the edge form a strictly convex quad.
  bool flippable(Side s) const;
  //     b               b
  //   / | \           /   \         s = a -> b, its apex c, across it d. Afterwards s.t holds (c,
  //   d, b)
  //  c  |  d   ->    c --- d        and the other triangle (c, a, d); the segment mark must be
  //  none.
  //   \ | /           \   /
  //     a               a
  void flip(Side s);
  // Divides t at point v, strictly inside it.
  void split_triangle(int t, int v);
  // Divides the edge at point v and the triangles beside it; both halves keep the segment. Where
  // v is off the line by rounding, the caller has tested that all parts stay counter-clockwise.
  void split_side(Side s, int v);
  // Whether the parts of split_side at p would be counter-clockwise.
  bool splittable(Side s, const Vec2& p) const;

  // Keeps the triangles marked so, in the order of their corners, which tells nothing of how they
  // came about; points stay. Handles to triangles change.
  void keep(const RunContext& context, const std::vector<char>& kept);

  // Flips the listed edges, and those the flips disturb, while `wants_flip(side)` says so. Ends if
  // that criterion is strict in exact arithmetic; `flip_limit` bounds it otherwise.
  template <class WantsFlip>
  void restore(std::vector<Side>& pending, std::size_t flip_limit, WantsFlip&& wants_flip);
  // The sides opposite v in all triangles about it.
  void append_link(int v, std::vector<Side>& out) const;

 private:
  Triangle& tri(int t) { return triangles_[static_cast<std::size_t>(t)]; }
  void set_triangle(int t, std::array<int, 3> v, std::array<int, 3> n, std::array<int, 3> segment);
  void relink(int t, int i, int old_neighbour);

  std::vector<Vec2> points_;
  std::vector<Triangle> triangles_;
  std::vector<int> triangle_of_;
};

template <class WantsFlip>
void PlanarTriangulation::restore(std::vector<Side>& pending, std::size_t flip_limit,
                                  WantsFlip&& wants_flip) {
  std::size_t flips = 0;
  while (!pending.empty() && flips < flip_limit) {
    const Side s = pending.back();
    pending.pop_back();
    const int other = triangle(s.t).n[s.i];
    if (other < 0 || segment(s) >= 0 || !wants_flip(s)) continue;
    flip(s);
    ++flips;
    for (const int t : {s.t, other}) {
      for (int i = 0; i < 3; ++i) {
        if (triangle(t).n[i] != s.t && triangle(t).n[i] != other) pending.push_back({t, i});
      }
    }
  }
  pending.clear();
}

}  // namespace advlayers
