#include "mesher/triangle_cause.h"

#include <gtest/gtest.h>

#include "mesh_fixtures.h"

namespace advlayers {
namespace {

using Causes = std::map<std::string, int>;

// A grid whose inner vertices and faces are all core; the rim is the CAD's boundary.
SurfaceMesh core_grid(int nx, int ny) {
  SurfaceMesh mesh = triangle_grid(nx, ny);
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const Vec3& p = mesh.position(VertexH(i));
    const bool rim = p.x() == 0.0 || p.y() == 0.0 || p.x() == nx || p.y() == ny;
    mesh.data(VertexH(i)).support = rim ? Support::kEdge : Support::kPatch;
  }
  return mesh;
}

TEST(TriangleCause, ATriangleBesideAFreeVertexIsTheCores) {
  const SurfaceMesh mesh = core_grid(2, 2);  // the corner triangles see no free vertex
  EXPECT_EQ(triangle_causes(RunContext(), mesh), (Causes{{"core", 6}, {"collision", 2}}));
}

TEST(TriangleCause, AStripWithoutFreeVertexIsARestByItsSize) {
  EXPECT_EQ(triangle_causes(RunContext(), core_grid(3, 1)), (Causes{{"last loop", 6}}));
  EXPECT_EQ(triangle_causes(RunContext(), core_grid(4, 1)), (Causes{{"collision", 8}}));
}

TEST(TriangleCause, AnElementOfALayerIsACollapse) {
  SurfaceMesh mesh = core_grid(1, 1);
  mesh.data(FaceH(0)).layer = 1;
  EXPECT_EQ(triangle_causes(RunContext(), mesh), (Causes{{"collapse", 1}, {"closing", 1}}));
}

TEST(TriangleCause, AColumnThatEndedIsAStep) {
  SurfaceMesh mesh = core_grid(3, 1);
  mesh.data(VertexH(4)).parent = VertexH(0);  // (0, 1) was extruded from (0, 0)
  mesh.data(VertexH(4)).layer = 1;
  EXPECT_EQ(triangle_causes(RunContext(), mesh), (Causes{{"step", 1}, {"last loop", 5}}));
}

TEST(TriangleCause, QuadsHaveNone) {
  SurfaceMesh mesh = core_grid(1, 1);
  mesh.combine(inner_diagonal(mesh));
  EXPECT_EQ(triangle_causes(RunContext(), mesh), Causes{});
}

}  // namespace
}  // namespace advlayers
