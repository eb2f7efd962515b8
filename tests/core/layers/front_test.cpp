#include "layers/front.h"
#include "base/angles.h"

#include <gtest/gtest.h>

#include "base/directions.h"
#include "layers/concave_scaling.h"
#include "layers/front_index.h"
#include "layers/walled_grid.h"

namespace advlayers::test {
namespace {

int node_at(const Front& front, VertexH v) {
  for (int i = 0; i < front.size(); ++i) {
    if (front[i].vertex == v) return i;
  }
  return -1;
}

// Every edge of the front is an edge of the mesh with the core on its left, and the links of its
// two nodes agree.
void expect_linked(const Front& front, const SurfaceMesh& mesh) {
  for (int i = 0; i < front.size(); ++i) {
    const FrontNode& node = front[i];
    if (!node.active || node.next < 0) continue;
    EXPECT_TRUE(front[node.next].active);
    EXPECT_EQ(front[node.next].prev, i);
    const HalfedgeH h = mesh.find_halfedge(node.vertex, front[node.next].vertex);
    ASSERT_TRUE(h.valid());
    EXPECT_FALSE(mesh.is_border(h));
  }
}

// A corner between two edges of these lengths, seen from above.
NodeShape corner_of(double degrees, double length_next, double length_prev) {
  NodeShape shape;
  shape.angle = degrees * kDegree;
  shape.length_next = length_next;
  shape.length_prev = length_prev;
  return shape;
}

TEST(TurnAngle, IsMeasuredCounterClockwise) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  EXPECT_NEAR(turn_angle(x, y, z), 90 * kDegree, 1e-14);
  EXPECT_NEAR(turn_angle(y, x, z), 270 * kDegree, 1e-14);
  EXPECT_NEAR(turn_angle(x, -x, z), 180 * kDegree, 1e-14);
  EXPECT_NEAR(turn_angle(x, y, -z), 270 * kDegree, 1e-14);
  EXPECT_NEAR(turn_angle(x, x, z), 0.0, 1e-14);
}

TEST(Front, RunsRoundTheGridWithTheCoreOnItsLeft) {
  const SurfaceMesh mesh = walled_grid(3, 2);
  const Front front(mesh, walls_on({0, 1, 2, 3}));
  ASSERT_EQ(front.size(), 10);
  EXPECT_EQ(front.active_count(), 10);
  EXPECT_EQ(front.ring_size(0), 10);
  EXPECT_TRUE(front.idle_edges().empty());
  expect_linked(front, mesh);
  for (const FrontNode& node : front.nodes()) EXPECT_EQ(node.root, node.vertex);
}

TEST(Front, IsAChainWhereOneSideIsAWall) {
  const SurfaceMesh mesh = walled_grid(3, 2);
  const Front front(mesh, walls_on({0}));
  ASSERT_EQ(front.size(), 4);
  EXPECT_EQ(front.idle_edges().size(), 7u);
  expect_linked(front, mesh);
  const int first = node_at(front, at(3, 0, 0)), last = node_at(front, at(3, 3, 0));
  EXPECT_EQ(front[first].prev, -1);
  EXPECT_EQ(front[last].next, -1);
  EXPECT_EQ(front.ring_size(first), -1);
}

TEST(Front, TakesTheMeanHeightAndTheFewerLayersBetweenTwoWalls) {
  const SurfaceMesh mesh = walled_grid(2, 2);
  WallPlan plan = walls_on({0, 1});
  plan.edges[EdgeId(0)].growth.layers_left = 7;
  plan.edges[EdgeId(1)].growth.layers_left = 4;
  plan.edges[EdgeId(1)].growth.height = 0.3;
  const Front front(mesh, plan);
  const FrontNode& corner = front[node_at(front, at(2, 2, 0))];
  EXPECT_NEAR(corner.growth.height, 0.2, 1e-15);
  EXPECT_EQ(corner.growth.layers_left, 4);
  EXPECT_EQ(front[node_at(front, at(2, 1, 0))].growth.layers_left, 7);
}

TEST(Front, BridgeTakesTheRunBetweenOut) {
  const SurfaceMesh mesh = walled_grid(3, 2);
  Front front(mesh, walls_on({0, 1, 2, 3}));
  const int a = node_at(front, at(3, 0, 0)), d = node_at(front, at(3, 3, 0));
  front.bridge(a, d);
  EXPECT_EQ(front.active_count(), 8);
  EXPECT_EQ(front.ring_size(a), 8);
  EXPECT_EQ(front[a].next, d);
  EXPECT_FALSE(front[node_at(front, at(3, 2, 0))].active);
}

TEST(Front, ARungMakesTwoRingsThatTurnAtIt) {
  SurfaceMesh mesh = walled_grid(4, 1);
  Front front(mesh, walls_on({0, 1, 2, 3}));
  const int p = node_at(front, at(4, 2, 0)), q = node_at(front, at(4, 2, 1));
  const int ring = front.ring_size(p);
  front.split_at_rung(p, q);
  EXPECT_EQ(front.active_count(), ring + 2);
  EXPECT_EQ(front.ring_size(p) + front.ring_size(q), ring + 2);
  EXPECT_EQ(front.ring_size(p), 6);  // three segments' worth of nodes on each side
  EXPECT_EQ(front[front[p].next].vertex, front[q].vertex);
  EXPECT_EQ(front[front[q].next].vertex, front[p].vertex);
  expect_linked(front, mesh);
}

TEST(NodeShape, TellsCornersAndStraightRuns) {
  const SurfaceMesh mesh = walled_grid(3, 2);
  const Front front(mesh, walls_on({0, 1, 2, 3}));
  const NodeShape straight = node_shape(mesh, front, node_at(front, at(3, 1, 0)));
  EXPECT_NEAR(straight.angle, M_PI, 1e-14);
  EXPECT_LT((straight.inward - Vec3::UnitY()).norm(), 1e-14);
  const NodeShape corner = node_shape(mesh, front, node_at(front, at(3, 0, 0)));
  EXPECT_NEAR(corner.angle, 0.5 * M_PI, 1e-14);
  EXPECT_NEAR(corner.turn(), 0.5 * M_PI, 1e-14);
  EXPECT_LT((corner.inward - Vec3(1, 1, 0).normalized()).norm(), 1e-14);
  EXPECT_NEAR(corner.length(), 1.0, 1e-14);
}

TEST(NodeShape, IsMirroredAtAChainsEnd) {
  const SurfaceMesh mesh = walled_grid(3, 2);
  const Front front(mesh, walls_on({0}));
  const NodeShape end = node_shape(mesh, front, node_at(front, at(3, 0, 0)));
  EXPECT_NEAR(end.angle, M_PI, 1e-14);
  EXPECT_LT((end.inward - Vec3::UnitY()).norm(), 1e-14);
}

TEST(ConcaveFactor, LeavesStraightFrontsAlone) {
  for (const double degrees : {161.0, 170.0, 180.0, 190.0, 199.0}) {
    EXPECT_EQ(concave_factor(corner_of(degrees, 10, 10), 1.0), 1.0) << degrees;
  }
}

// The factor keeps the layer's thickness perpendicular to both edges: f sin(theta) = 1.
TEST(ConcaveFactor, KeepsTheThicknessBesideACorner) {
  for (const double degrees : {60.0, 90.0, 120.0, 150.0, 210.0, 240.0}) {
    const double factor = concave_factor(corner_of(degrees, 100, 100), 1.0);
    EXPECT_NEAR(factor * std::sin(0.5 * degrees * kDegree), 1.0, 0.03) << degrees;
  }
}

TEST(ConcaveFactor, NeverPassesTheShorterEdge) {
  EXPECT_NEAR(concave_factor(corner_of(30, 2.5, 9), 1.0), 2.5, 1e-12);
  EXPECT_NEAR(concave_factor(corner_of(30, 9, 2.5), 1.0), 2.5, 1e-12);
  EXPECT_NEAR(concave_factor(corner_of(30, 0.5, 9), 1.0), 1.0, 1e-12);  // but never shrinks either
}

TEST(ConcaveFactor, DoesNotThrowAConvexCornersKidFarAhead) {
  EXPECT_LE(concave_factor(corner_of(300, 10, 10), 1.0), 1.5);
  EXPECT_GE(concave_factor(corner_of(300, 10, 10), 1.0), 1.0);
}

TEST(FrontIndex, SeesTheFrontAhead) {
  const SurfaceMesh mesh = walled_grid(8, 2);
  const Front front(mesh, walls_on({0, 1, 2, 3}));
  const FrontIndex fronts(mesh, front);
  const int i = node_at(front, at(8, 4, 0));
  FrontIndex::Hit hit;
  ASSERT_TRUE(fronts.nearest_ahead(i, node_shape(mesh, front, i), 3.0, hit));
  EXPECT_NEAR(hit.distance, 2.0, 1e-14);
  EXPECT_GE(hit.node, 0);
  for (const VertexH v : {hit.from, hit.to}) EXPECT_EQ(mesh.position(v).y(), 2.0);
  EXPECT_FALSE(fronts.nearest_ahead(i, node_shape(mesh, front, i), 1.9, hit));
}

TEST(FrontIndex, SeesAnIdleEdgeAsStanding) {
  const SurfaceMesh mesh = walled_grid(8, 2);
  const Front front(mesh, walls_on({0}));
  const FrontIndex fronts(mesh, front);
  const int i = node_at(front, at(8, 4, 0));
  FrontIndex::Hit hit;
  ASSERT_TRUE(fronts.nearest_ahead(i, node_shape(mesh, front, i), 3.0, hit));
  EXPECT_NEAR(hit.distance, 2.0, 1e-14);
  EXPECT_EQ(hit.node, -1);
}

TEST(FrontIndex, LooksAheadOnly) {
  const SurfaceMesh mesh = walled_grid(8, 2);
  const Front front(mesh, walls_on({0, 1, 2, 3}));
  const FrontIndex fronts(mesh, front);
  const int i = node_at(front, at(8, 4, 0));
  NodeShape shape = node_shape(mesh, front, i);
  shape.inward = -shape.inward;
  FrontIndex::Hit hit;
  EXPECT_FALSE(fronts.nearest_ahead(i, shape, 3.0, hit));
}

// The two sides of a thin shell are near in space, and no obstacle to each other.
TEST(FrontIndex, OverlooksTheOtherSideOfAThinShell) {
  SurfaceMesh mesh = walled_grid(8, 2);
  for (int i = 0; i <= 8; ++i) mesh.data(at(8, i, 2)).normal = -Vec3::UnitZ();
  const Front front(mesh, walls_on({0, 2}));
  const FrontIndex fronts(mesh, front);
  const int i = node_at(front, at(8, 4, 0));
  FrontIndex::Hit hit;
  EXPECT_FALSE(fronts.nearest_ahead(i, node_shape(mesh, front, i), 2.5, hit));
}

}  // namespace
}  // namespace advlayers::test
