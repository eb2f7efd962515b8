#include "layers/recover.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layers/patch_layers.h"
#include "layers/walled_grid.h"
#include "mesh/triangle_measures.h"

namespace advlayers::test {
namespace {

struct Counts {
  explicit Counts(const SurfaceMesh& mesh)
      : vertices(mesh.vertex_count()), edges(mesh.edge_count()), faces(mesh.face_count()) {}
  int vertices, edges, faces;
  bool operator==(const Counts& other) const {
    return vertices == other.vertices && edges == other.edges && faces == other.faces;
  }
};

void expect_sound(const SurfaceMesh& mesh) {
  EXPECT_VALID(mesh);
  EXPECT_UPRIGHT(mesh);
  EXPECT_EQ(euler_number(mesh), 1);
}

class OnAGrid : public ::testing::Test {
 protected:
  SurfaceMesh mesh = walled_grid(4, 4);
  ReconnectLimits limits;
  VetoTally tally{};

  VertexH v(int i, int j) const { return at(4, i, j); }
  VertexH insert(VertexH from, double x, double y) {
    return insert_point(mesh, from, flat_vertex(x, y), limits, tally);
  }
  HalfedgeH recover(VertexH a, VertexH b) { return recover_edge(mesh, a, b, limits, tally); }
};
using InsertPoint = OnAGrid;
using RecoverEdge = OnAGrid;
using ClearRegion = OnAGrid;
using RemoveCoreVertex = OnAGrid;

TEST_F(InsertPoint, SplitsTheFaceItLiesIn) {
  for (const VertexH from : {v(0, 1), v(0, 0), v(4, 3), v(2, 2)}) {
    SurfaceMesh grid = mesh;
    const VertexH made = insert_point(grid, from, flat_vertex(2.7, 1.2), limits, tally);
    ASSERT_TRUE(made.valid());
    EXPECT_EQ(grid.valence(made), 3);
    EXPECT_EQ(grid.face_count(), mesh.face_count() + 2);
    EXPECT_EQ(grid.position(made), Vec3(2.7, 1.2, 0.0));
    expect_sound(grid);
  }
}

TEST_F(InsertPoint, SplitsTheEdgeItLiesOn) {
  const VertexH made = insert(v(1, 0), 2.3, 1.3);  // on a diagonal
  ASSERT_TRUE(made.valid());
  EXPECT_EQ(mesh.valence(made), 4);
  expect_sound(mesh);
}

TEST_F(InsertPoint, SplitsAnEdgeOfItsOwnOrigin) {
  const VertexH made = insert(v(1, 0), 1.0, 0.25);
  ASSERT_TRUE(made.valid());
  EXPECT_EQ(mesh.valence(made), 4);
  EXPECT_TRUE(mesh.find_halfedge(v(1, 0), made).valid());
  expect_sound(mesh);
}

TEST_F(InsertPoint, RemovesACoreVertexInTheWay) {
  const VertexH made = insert(v(1, 0), 1.0, 1.5);
  ASSERT_TRUE(made.valid());
  EXPECT_FALSE(mesh.alive(v(1, 1)));
  expect_sound(mesh);
}

TEST_F(InsertPoint, IsRefusedBehindAFrozenEdge) {
  freeze_run(mesh, 4, 1, 0, 1, 4);
  const Counts before(mesh);
  EXPECT_FALSE(insert(v(0, 1), 2.6, 1.3).valid());
  EXPECT_TRUE(Counts(mesh) == before);
  expect_sound(mesh);
}

TEST_F(InsertPoint, IsRefusedOutsideTheMesh) {
  const Counts before(mesh);
  EXPECT_FALSE(insert(v(1, 0), 1.7, -0.4).valid());
  EXPECT_FALSE(insert(v(1, 0), 5.2, 1.7).valid());
  EXPECT_TRUE(Counts(mesh) == before);
  expect_sound(mesh);
}

TEST_F(RecoverEdge, GivesTheEdgeThatIsThere) {
  const HalfedgeH h = recover(v(1, 1), v(2, 2));
  EXPECT_EQ(h, mesh.find_halfedge(v(1, 1), v(2, 2)));
}

TEST_F(RecoverEdge, SwapsEveryEdgeBetweenAway) {
  for (const auto& [a, b] : {std::pair{v(0, 1), v(4, 2)}, std::pair{v(0, 4), v(3, 0)},
                             std::pair{v(1, 0), v(2, 4)}, std::pair{v(4, 1), v(0, 2)}}) {
    SurfaceMesh grid = mesh;
    const HalfedgeH h = recover_edge(grid, a, b, limits, tally);
    ASSERT_TRUE(h.valid());
    EXPECT_EQ(grid.from(h), a);
    EXPECT_EQ(grid.to(h), b);
    EXPECT_EQ(grid.face_count(), mesh.face_count());
    EXPECT_EQ(grid.vertex_count(), mesh.vertex_count());
    expect_sound(grid);
  }
}

TEST_F(RecoverEdge, RemovesCoreVerticesOnTheSegment) {
  const HalfedgeH h = recover(v(0, 2), v(4, 2));
  ASSERT_TRUE(h.valid());
  EXPECT_EQ(mesh.to(h), v(4, 2));
  for (const int i : {1, 2, 3}) EXPECT_FALSE(mesh.alive(v(i, 2)));
  expect_sound(mesh);
}

TEST_F(RecoverEdge, IsRefusedByAVertexOfALayer) {
  mesh.data(v(2, 2)).layer = 1;
  EXPECT_FALSE(recover(v(0, 2), v(4, 2)).valid());
  EXPECT_TRUE(mesh.alive(v(2, 2)));
  expect_sound(mesh);
}

TEST_F(RecoverEdge, IsRefusedByAFrozenEdge) {
  freeze_run(mesh, 4, 2, 1, 2, 2);
  const Counts before(mesh);
  EXPECT_FALSE(recover(v(0, 1), v(4, 2)).valid());
  EXPECT_TRUE(mesh.find_halfedge(v(2, 1), v(2, 2)).valid());
  EXPECT_TRUE(Counts(mesh) == before);
  expect_sound(mesh);
}

// Freezes the square between (1, 1) and (3, 3), and makes its corners vertices of a layer.
void frame(SurfaceMesh& mesh) {
  freeze_run(mesh, 4, 1, 1, 3, 1);
  freeze_run(mesh, 4, 3, 1, 3, 3);
  freeze_run(mesh, 4, 3, 3, 1, 3);
  freeze_run(mesh, 4, 1, 3, 1, 1);
  for (int k = 1; k <= 3; ++k) {
    for (const VertexH w : {at(4, k, 1), at(4, k, 3), at(4, 1, k), at(4, 3, k)}) {
      mesh.data(w).layer = 1;
    }
  }
}

TEST_F(ClearRegion, RemovesTheVerticesInsideAndTellsTheFaces) {
  frame(mesh);
  const HalfedgeH side = mesh.find_halfedge(v(1, 1), v(2, 1));
  const std::vector<FaceH> faces = clear_region(mesh, side, 100, limits, tally);
  EXPECT_EQ(faces.size(), 6u);  // eight corners, nothing inside
  EXPECT_FALSE(mesh.alive(v(2, 2)));
  EXPECT_NE(std::find(faces.begin(), faces.end(), mesh.face(side)), faces.end());
  double area2 = 0.0;
  for (const FaceH f : faces) {
    const HalfedgeH h = mesh.halfedge(f);
    area2 += signed_area2(corner(mesh, mesh.from(h)), corner(mesh, mesh.to(h)),
                          corner(mesh, mesh.to(mesh.next(h))));
  }
  EXPECT_NEAR(area2, 2.0 * 4.0, 1e-12);
  expect_sound(mesh);
}

TEST_F(ClearRegion, GivesUpOnALargerRegion) {
  frame(mesh);
  const Counts before(mesh);
  const HalfedgeH side = mesh.find_halfedge(v(1, 1), v(2, 1));
  EXPECT_TRUE(clear_region(mesh, side, 5, limits, tally).empty());
  EXPECT_TRUE(Counts(mesh) == before);
}

TEST_F(RemoveCoreVertex, TakesOneVertexAndTwoFaces) {
  const Counts before(mesh);
  ASSERT_TRUE(remove_core_vertex(mesh, v(2, 2), Removal::kGuarded, limits, tally));
  EXPECT_FALSE(mesh.alive(v(2, 2)));
  EXPECT_EQ(mesh.vertex_count(), before.vertices - 1);
  EXPECT_EQ(mesh.face_count(), before.faces - 2);
  expect_sound(mesh);
}

TEST_F(RemoveCoreVertex, KnowsWhatIsCore) {
  EXPECT_TRUE(is_core_vertex(mesh, v(2, 2)));
  EXPECT_FALSE(is_core_vertex(mesh, v(0, 2)));
  mesh.data(v(2, 2)).layer = 3;
  EXPECT_FALSE(is_core_vertex(mesh, v(2, 2)));
}

TEST_F(RemoveCoreVertex, KeepsTheLimitsUnlessItIsForced) {
  limits.area_ratio = 1.5;  // every collapse in the grid makes one triangle twice the other
  const Counts before(mesh);
  EXPECT_FALSE(remove_core_vertex(mesh, v(2, 2), Removal::kGuarded, limits, tally));
  EXPECT_TRUE(Counts(mesh) == before);
  EXPECT_GT(tally[static_cast<std::size_t>(Veto::kAreaRatio)], 0);
  EXPECT_TRUE(remove_core_vertex(mesh, v(2, 2), Removal::kForced, limits, tally));
  expect_sound(mesh);
}

TEST_F(RemoveCoreVertex, LeavesAVertexThatFrozenEdgesHold) {
  for (const HalfedgeH h : mesh.around(v(2, 2))) {
    mesh.set_frozen(h, true);
  }
  const Counts before(mesh);
  EXPECT_FALSE(remove_core_vertex(mesh, v(2, 2), Removal::kForced, limits, tally));
  EXPECT_TRUE(Counts(mesh) == before);
  expect_sound(mesh);
}

TEST(ThawCoreEdges, FreesWhatHasCoreOnBothSides) {
  SurfaceMesh mesh = walled_grid(4, 4);
  const auto edge = [&](int i0, int j0, int i1, int j1) {
    return mesh.find_halfedge(at(4, i0, j0), at(4, i1, j1));
  };
  const HalfedgeH rung = edge(2, 2, 2, 3), front = edge(0, 1, 1, 1), wall = edge(1, 0, 2, 0);
  for (const HalfedgeH h : {rung, front}) mesh.set_frozen(h, true);
  mesh.data(mesh.face(front)).layer = 1;
  thaw_core_edges(mesh);
  EXPECT_FALSE(mesh.frozen(rung));
  EXPECT_TRUE(mesh.frozen(front));
  EXPECT_TRUE(mesh.frozen(wall));
}

}  // namespace
}  // namespace advlayers::test
