// What no solver could use, found in meshes that are otherwise sound.
#include "measure/mesh_flaws.h"

#include <gtest/gtest.h>

namespace advlayers::test {
namespace {

VertexH add(SurfaceMesh& mesh, double x, double y) {
  VertexData data;
  data.point.xyz = Vec3(x, y, 0);
  data.normal = Vec3::UnitZ();
  return mesh.add_vertex(data);
}

// Two triangles over the segment from (0, 0) to (1, 0), the upper one of that height.
SurfaceMesh two_triangles(double height) {
  SurfaceMesh mesh;
  const VertexH a = add(mesh, 0, 0), b = add(mesh, 1, 0), c = add(mesh, 0.5, height),
                d = add(mesh, 0.5, -1);
  mesh.build({{a, b, c}, {b, a, d}});
  return mesh;
}

TEST(MeshFlaws, SoundElementsHaveNone) {
  const MeshFlaws flaws = find_mesh_flaws(RunContext(), two_triangles(1.0), 1e-9);
  EXPECT_TRUE(flaws.flat.empty() && flaws.needles.empty() && flaws.coincident.empty());
}

TEST(MeshFlaws, FlatElementsAndNeedlesAreToldApart) {
  const MeshFlaws flat = find_mesh_flaws(RunContext(), two_triangles(0.0), 1e-9);
  EXPECT_EQ(flat.flat, std::vector<FaceH>{FaceH(0)});
  EXPECT_TRUE(flat.needles.empty());
  const MeshFlaws needle = find_mesh_flaws(RunContext(), two_triangles(4e-4), 1e-9);
  EXPECT_EQ(needle.needles, std::vector<FaceH>{FaceH(0)});
  EXPECT_TRUE(needle.flat.empty());
  EXPECT_TRUE(find_mesh_flaws(RunContext(), two_triangles(2e-3), 1e-9).needles.empty());
}

TEST(MeshFlaws, VerticesInOnePlaceAreFoundButForThoseOfTheBoundary) {
  SurfaceMesh mesh;
  const VertexH a = add(mesh, 0, 0), b = add(mesh, 1, 0), c = add(mesh, 0.5, 1),
                again = add(mesh, 1 + 1e-10, 0), d = add(mesh, 2, 0), e = add(mesh, 1.5, 1);
  mesh.build({{a, b, c}, {again, d, e}});
  EXPECT_EQ(find_mesh_flaws(RunContext(), mesh, 1e-9).coincident, std::vector<VertexH>{again});
  EXPECT_TRUE(find_mesh_flaws(RunContext(), mesh, 1e-11).coincident.empty());
  mesh.data(b).node = NodeId(7);
  EXPECT_EQ(find_mesh_flaws(RunContext(), mesh, 1e-9).coincident, std::vector<VertexH>{again});
  mesh.data(again).node = NodeId(8);
  EXPECT_TRUE(find_mesh_flaws(RunContext(), mesh, 1e-9).coincident.empty());
}

}  // namespace
}  // namespace advlayers::test
