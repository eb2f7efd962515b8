#include "quads/pentagon.h"

#include <gtest/gtest.h>

#include "mesh_fixtures.h"

namespace advlayers {
namespace {

// The shared half-edge keeps its direction and its sides, whatever becomes of the cut.
TEST(Recut, LeavesTheMeshAsItWasWhereItRefuses) {
  int refused = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SurfaceMesh mesh = triangle_grid(3, 3);
    random_operations(mesh, 60, seed);
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
      const HalfedgeH h(i), t = SurfaceMesh::twin(h);
      for (const auto cut : {PentagonCut::kA, PentagonCut::kB, PentagonCut::kC, PentagonCut::kD}) {
        if (!mesh.alive(h) || mesh.is_border(h) || mesh.is_border(t)) continue;
        if (!mesh.is_triangle(h) || mesh.is_triangle(t)) continue;
        const VertexH from = mesh.from(h), to = mesh.to(h);
        const VertexH apex = mesh.to(mesh.next(h));
        const FaceH triangle = mesh.face(h), quad = mesh.face(t);
        const int faces = mesh.face_count();
        if (recut(mesh, h, cut)) continue;
        ++refused;
        EXPECT_EQ(mesh.from(h), from);
        EXPECT_EQ(mesh.to(h), to);
        EXPECT_EQ(mesh.to(mesh.next(h)), apex);
        EXPECT_TRUE(mesh.is_triangle(h));
        EXPECT_FALSE(mesh.is_triangle(t));
        EXPECT_EQ(mesh.face(h), triangle);
        EXPECT_EQ(mesh.face(t), quad);
        EXPECT_EQ(mesh.face_count(), faces);
        EXPECT_VALID(mesh);
      }
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace advlayers
