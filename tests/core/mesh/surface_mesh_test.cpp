#include "mesh/surface_mesh.h"

#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "mesh/validate.h"
#include "mesh_fixtures.h"

namespace advlayers {
namespace {

TEST(SurfaceMesh, GridIsValidDisc) {
  const SurfaceMesh mesh = triangle_grid(4, 3);
  EXPECT_VALID(mesh);
  EXPECT_EQ(euler_number(mesh), 1);
}

TEST(SurfaceMesh, BuildRefusesTwoFacesOnOneSide) {
  SurfaceMesh mesh;
  const VertexH a = mesh.add_vertex({}), b = mesh.add_vertex({}), c = mesh.add_vertex({});
  EXPECT_THROW(mesh.build({{a, b, c}, {a, b, c}}), InternalError);
}

TEST(SurfaceMesh, SplitFaceMakesThreeTriangles) {
  SurfaceMesh mesh = triangle_grid(2, 2);
  const int faces = mesh.face_count();
  mesh.split_face(FaceH(0), centroid_of(mesh, FaceH(0)));
  EXPECT_EQ(mesh.face_count(), faces + 2);
  EXPECT_VALID(mesh);
  EXPECT_EQ(euler_number(mesh), 1);
}

TEST(SurfaceMesh, SplitEdgeHalvesBothSidesAndTheBorder) {
  for (std::size_t i = 0; i < triangle_grid(2, 2).halfedge_capacity(); ++i) {
    SurfaceMesh mesh = triangle_grid(2, 2);
    const HalfedgeH h(i);
    const int sides = mesh.is_border(h) || mesh.is_border(SurfaceMesh::twin(h)) ? 1 : 2;
    const int faces = mesh.face_count();
    ASSERT_EQ(mesh.split_edge_veto(h), Veto::kNone);
    mesh.split_edge(h, midpoint_of(mesh, h));
    EXPECT_EQ(mesh.face_count(), faces + sides);
    EXPECT_VALID(mesh);
  }
}

TEST(SurfaceMesh, FlipTurnsCounterClockwiseAndFourTimesIsIdentity) {
  SurfaceMesh mesh = triangle_grid(2, 2);
  const HalfedgeH h = inner_diagonal(mesh);
  const VertexH a = mesh.from(h), b = mesh.to(h), left = mesh.to(mesh.next(h));
  ASSERT_EQ(mesh.flip_veto(h), Veto::kNone);
  mesh.flip(h);
  EXPECT_EQ(mesh.to(h), left);
  EXPECT_VALID(mesh);
  for (int k = 0; k < 3; ++k) mesh.flip(h);
  EXPECT_EQ(mesh.from(h), a);
  EXPECT_EQ(mesh.to(h), b);
  EXPECT_VALID(mesh);
}

TEST(SurfaceMesh, FlipRefusesFrozenBorderAndDoubledEdge) {
  SurfaceMesh mesh = triangle_grid(2, 2);
  const HalfedgeH h = inner_diagonal(mesh);
  mesh.set_frozen(h, true);
  EXPECT_EQ(mesh.flip_veto(h), Veto::kFrozen);
  EXPECT_EQ(mesh.flip_veto(mesh.outgoing(VertexH(0))), Veto::kBorder);
  SurfaceMesh star = triangle_grid(1, 1);
  const VertexH v = star.split_face(FaceH(0), centroid_of(star, FaceH(0)));
  const HalfedgeH spoke = star.outgoing(v);
  EXPECT_EQ(star.flip_veto(spoke), Veto::kEdgeExists);
}

TEST(SurfaceMesh, CollapseRefusesPinchAndKeepsFrozenOfMergedEdges) {
  SurfaceMesh mesh = triangle_grid(4, 4);
  const VertexH centre = VertexH(12);
  ASSERT_FALSE(mesh.is_border(centre));
  HalfedgeH h = mesh.outgoing(centre);
  const HalfedgeH side = mesh.prev(h);  // c -> centre merges into c -> to(h)
  const VertexH c = mesh.from(side), b = mesh.to(h);
  mesh.set_frozen(side, true);
  ASSERT_EQ(mesh.collapse_veto(h), Veto::kNone);
  mesh.collapse(h);
  EXPECT_VALID(mesh);
  EXPECT_TRUE(mesh.frozen(mesh.find_halfedge(c, b)));
  EXPECT_FALSE(mesh.alive(centre));
}

TEST(SurfaceMesh, CombineAndDivideAreInverse) {
  SurfaceMesh mesh = triangle_grid(3, 3);
  const int faces = mesh.face_count();
  const HalfedgeH h = inner_diagonal(mesh);
  const VertexH a = mesh.from(h), b = mesh.to(h);
  ASSERT_EQ(mesh.combine_veto(h), Veto::kNone);
  const FaceH quad = mesh.combine(h);
  EXPECT_EQ(mesh.degree(quad), 4);
  EXPECT_VALID(mesh);
  const HalfedgeH back = mesh.divide(quad, a);
  EXPECT_EQ(mesh.to(back), b);
  EXPECT_EQ(mesh.face_count(), faces);
  EXPECT_VALID(mesh);
}

TEST(SurfaceMesh, ObserverSeesEveryFaceThatComesAndGoes) {
  struct Counter : MeshObserver {
    void face_created(const SurfaceMesh&, FaceH) override { ++faces; }
    void face_deleted(const SurfaceMesh&, FaceH) override { --faces; }
    void vertex_created(const SurfaceMesh&, VertexH) override { ++vertices; }
    void vertex_deleted(const SurfaceMesh&, VertexH) override { --vertices; }
    int faces = 0, vertices = 0;
  } counter;
  SurfaceMesh mesh = triangle_grid(4, 4);
  counter.faces = mesh.face_count();
  counter.vertices = mesh.vertex_count();
  mesh.add_observer(&counter);
  random_operations(mesh, 400, 7);
  EXPECT_EQ(counter.faces, mesh.face_count());
  EXPECT_EQ(counter.vertices, mesh.vertex_count());
}

TEST(SurfaceMesh, StaysValidUnderRandomOperationsAndInOrder) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SurfaceMesh mesh = triangle_grid(5, 5);
    random_operations(mesh, 600, seed);
    EXPECT_VALID(mesh);
    EXPECT_EQ(euler_number(mesh), 1);
    const int faces = mesh.face_count();
    const int edges = mesh.edge_count();
    mesh.put_in_order(RunContext());
    EXPECT_EQ(static_cast<int>(mesh.face_capacity()), faces);
    EXPECT_EQ(static_cast<int>(mesh.halfedge_capacity()), 2 * edges);
    for (std::size_t i = 2; i < mesh.halfedge_capacity(); i += 2) {
      const HalfedgeH before(i - 2), h(i);
      EXPECT_LT(std::make_pair(mesh.from(before), mesh.to(before)),
                std::make_pair(mesh.from(h), mesh.to(h)));
    }
    EXPECT_VALID(mesh);
    random_operations(mesh, 100, seed + 100);
    EXPECT_VALID(mesh);
  }
}

}  // namespace
}  // namespace advlayers
