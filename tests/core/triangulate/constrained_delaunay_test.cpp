#include "triangulate/constrained_delaunay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "base/predicates.h"

namespace advlayers {
namespace {

using Polygon = std::vector<Vec2>;

double shoelace(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec2 &a = p[i], &b = p[(i + 1) % p.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

Polygon circle(int n, double radius, Vec2 center = {0, 0}, double turn = 1) {
  Polygon p;
  for (int i = 0; i < n; ++i) {
    const double angle = turn * 2 * M_PI * i / n;
    p.push_back(center + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return p;
}

// Loops and loose points, triangulated; fails the test where a segment meets another.
struct Carved {
  PlanarTriangulation mesh;
  int points = 0, segments = 0;
};

Carved triangulate_loops(const std::vector<Polygon>& loops, const Polygon& loose = {}) {
  Polygon points;
  for (const Polygon& loop : loops) points.insert(points.end(), loop.begin(), loop.end());
  points.insert(points.end(), loose.begin(), loose.end());
  const RunContext context;
  ConstrainedDelaunay cdt(context, points);
  int first = 0, mark = 0;
  for (const Polygon& loop : loops) {
    const int n = static_cast<int>(loop.size());
    for (int i = 0; i < n; ++i) {
      EXPECT_TRUE(cdt.constrain(first + i, first + (i + 1) % n, mark++).none());
    }
    first += n;
  }
  const auto range = cdt.carve(RunContext());
  EXPECT_GE(range.lowest, 0);
  EXPECT_LE(range.highest, 1);
  return {cdt.release(), static_cast<int>(points.size()), mark};
}

double apex_angle(const PlanarTriangulation& mesh, PlanarTriangulation::Side s) {
  const Vec2 &c = mesh.point(mesh.apex(s)), a = mesh.point(mesh.from(s)) - c,
             b = mesh.point(mesh.to(s)) - c;
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

void expect_valid(const PlanarTriangulation& mesh) {
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& tri = mesh.triangle(t);
    ASSERT_EQ(orient2d(mesh.point(tri.v[0]), mesh.point(tri.v[1]), mesh.point(tri.v[2])), 1);
    for (int i = 0; i < 3; ++i) {
      if (tri.n[i] < 0) {
        ASSERT_GE(tri.segment[i], 0) << "a border edge that is no segment";
        continue;
      }
      const auto other = mesh.opposite({t, i});
      ASSERT_EQ(other.t, tri.n[i]);
      ASSERT_EQ(mesh.from(other), mesh.to({t, i}));
      ASSERT_EQ(mesh.to(other), mesh.from({t, i}));
      ASSERT_EQ(mesh.segment(other), tri.segment[i]);
      if (tri.segment[i] < 0) {
        // The angles that face a free edge add up to pi at most.
        ASSERT_LT(apex_angle(mesh, {t, i}) + apex_angle(mesh, other), M_PI + 1e-7);
      }
    }
  }
}

double area(const PlanarTriangulation& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles()) {
    sum += shoelace({mesh.point(t.v[0]), mesh.point(t.v[1]), mesh.point(t.v[2])});
  }
  return sum;
}

int euler(const PlanarTriangulation& mesh) {
  std::set<int> vertices;
  int borders = 0;
  for (const auto& t : mesh.triangles()) {
    vertices.insert(t.v.begin(), t.v.end());
    for (const int n : t.n) borders += n < 0;
  }
  const int edges = (3 * mesh.triangle_count() + borders) / 2;
  return static_cast<int>(vertices.size()) - edges + mesh.triangle_count();
}

TEST(ConstrainedDelaunay, FillsASquareWithAHole) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, hole{{1, 1}, {1, 3}, {3, 3}, {3, 1}};
  const Carved carved = triangulate_loops({square, hole});
  expect_valid(carved.mesh);
  EXPECT_NEAR(area(carved.mesh), 12, 1e-12);
  EXPECT_EQ(euler(carved.mesh), 0);
}

TEST(ConstrainedDelaunay, ServesAThinAnnulus) {
  const Carved carved = triangulate_loops({circle(720, 1), circle(720, 0.999, {0, 0}, -1)});
  expect_valid(carved.mesh);
  EXPECT_EQ(carved.mesh.triangle_count(), 1440);
}

TEST(ConstrainedDelaunay, KeepsEverySegmentOfAStarWithTinyAngles) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(1e-3, 1);
  for (int round = 0; round < 200; ++round) {
    Polygon star = circle(40, 1);
    for (Vec2& p : star) p *= round % 2 ? radius(random) : std::pow(radius(random), 4);
    const Carved carved = triangulate_loops({star});
    expect_valid(carved.mesh);
    ASSERT_NEAR(area(carved.mesh), shoelace(star), 1e-12);
    ASSERT_EQ(euler(carved.mesh), 1);
    ASSERT_EQ(carved.mesh.triangle_count(), 38);
    for (int i = 0; i < 40; ++i) ASSERT_GE(carved.mesh.find_side(i, (i + 1) % 40).t, 0);
  }
}

TEST(ConstrainedDelaunay, TakesRandomPointsInsideLoops) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(-0.5, 0.5);
  for (int round = 0; round < 50; ++round) {
    Polygon loose;
    for (int i = 0; i < 100; ++i) loose.push_back({coordinate(random), coordinate(random)});
    const Carved carved = triangulate_loops({circle(17, 1), circle(9, 0.2, {0.7, 0}, -1)}, loose);
    expect_valid(carved.mesh);
    ASSERT_NEAR(area(carved.mesh), shoelace(circle(17, 1)) - shoelace(circle(9, 0.2)), 1e-12);
    ASSERT_EQ(euler(carved.mesh), 0);
  }
}

TEST(ConstrainedDelaunay, TakesGridsAndCollinearPoints) {
  Polygon loose;
  for (int i = 1; i < 20; ++i) {
    for (int j = 1; j < 20; ++j) loose.push_back({0.3 * i, 0.1 * j});
  }
  const Carved carved = triangulate_loops({{{0, 0}, {6, 0}, {6, 2}, {0, 2}}}, loose);
  expect_valid(carved.mesh);
  EXPECT_NEAR(area(carved.mesh), 12, 1e-12);
  EXPECT_EQ(euler(carved.mesh), 1);
}

TEST(ConstrainedDelaunay, NamesTheSegmentThatIsCrossed) {
  const RunContext context;
  ConstrainedDelaunay cdt(context, {{0, 0}, {2, 2}, {0, 2}, {2, 0}});
  EXPECT_TRUE(cdt.constrain(0, 1, 5).none());
  EXPECT_EQ(cdt.constrain(2, 3, 6).crossed, 5);
}

TEST(ConstrainedDelaunay, DividesASegmentAtAPointOnIt) {
  const RunContext context;
  ConstrainedDelaunay cdt(context, {{0, 0}, {3, 3}, {1, 1}, {2, 0}, {0, 2}});
  EXPECT_EQ(cdt.constrain(0, 1, 0).through, 2);
  EXPECT_GE(cdt.mesh().find_side(0, 2).t, 0);
  EXPECT_GE(cdt.mesh().find_side(2, 1).t, 0);
}

TEST(ConstrainedDelaunay, SharesTheVertexOfEqualPoints) {
  const RunContext context;
  const ConstrainedDelaunay cdt(context, {{0, 0}, {1, 0}, {0, 1}, {1, 0}});
  EXPECT_EQ(cdt.vertex(1), cdt.vertex(3));
  EXPECT_NE(cdt.vertex(0), cdt.vertex(1));
}

TEST(ConstrainedDelaunay, KeepsBothSidesOfASlit) {
  const RunContext context;
  ConstrainedDelaunay cdt(context, {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 2}, {3, 2}});
  for (int i = 0; i < 4; ++i) cdt.constrain(i, (i + 1) % 4, i);
  EXPECT_TRUE(cdt.constrain(4, 5, 4).none());
  EXPECT_EQ(cdt.constrain(5, 4, 5).overlaps, 4);
  cdt.carve(RunContext());
  const auto slit = cdt.mesh().find_side(4, 5);
  ASSERT_GE(slit.t, 0);
  EXPECT_GE(cdt.mesh().opposite(slit).t, 0);
  EXPECT_EQ(cdt.mesh().segment(slit), 4);
  EXPECT_NEAR(area(cdt.mesh()), 16, 1e-12);
}

TEST(ConstrainedDelaunay, RefusesPointsThatAreNotFinite) {
  const RunContext context;
  EXPECT_THROW(ConstrainedDelaunay(context, {{0, 0}, {std::nan(""), 0}}), InvalidInput);
}

TEST(ConstrainedDelaunay, StopsWhenAsked) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(ConstrainedDelaunay(context, circle(5000, 1)), Cancelled);
}

}  // namespace
}  // namespace advlayers
