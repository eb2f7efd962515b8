#include <gtest/gtest.h>

#include "mesh/validate.h"
#include "mesh_fixtures.h"

namespace advlayers {
namespace {

// The faces about an inner vertex, and the loop around them, counter-clockwise.
struct Disc {
  std::vector<FaceH> faces;
  std::vector<VertexH> loop;
};

Disc disc_about(const SurfaceMesh& mesh, VertexH v) {
  Disc disc;
  for (const HalfedgeH h : mesh.around_ccw(v)) {
    disc.faces.push_back(mesh.face(h));
    disc.loop.push_back(mesh.to(h));
  }
  return disc;
}

VertexH inner_vertex(const SurfaceMesh& mesh, int valence) {
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    if (!mesh.is_border(VertexH(i)) && mesh.valence(VertexH(i)) == valence) return VertexH(i);
  }
  return {};
}

TEST(ReplaceFaces, GivesADiscOtherFacesAndDropsItsInnerVertex) {
  SurfaceMesh mesh = triangle_grid(4, 4);
  const VertexH v = inner_vertex(mesh, 6);
  ASSERT_TRUE(v.valid());
  const Disc disc = disc_about(mesh, v);
  const int euler = euler_number(mesh), faces = mesh.face_count();
  const auto& l = disc.loop;
  const std::vector<std::vector<VertexH>> quads{{l[0], l[1], l[2], l[5]}, {l[2], l[3], l[4], l[5]}};
  ASSERT_EQ(mesh.replace_veto(disc.faces, quads), Veto::kNone);
  const std::vector<FaceH> made = mesh.replace(disc.faces, quads);
  EXPECT_VALID(mesh);
  EXPECT_EQ(euler_number(mesh), euler);
  EXPECT_EQ(mesh.face_count(), faces - 4);
  EXPECT_FALSE(mesh.alive(v));
  ASSERT_EQ(made.size(), 2u);
  for (const FaceH f : made) EXPECT_EQ(mesh.degree(f), 4);
}

TEST(ReplaceFaces, KeepsAnInnerVertexThatIsUsed) {
  SurfaceMesh mesh = triangle_grid(4, 4);
  const VertexH v = inner_vertex(mesh, 6);
  const Disc disc = disc_about(mesh, v);
  const auto& l = disc.loop;
  const std::vector<std::vector<VertexH>> quads{
      {v, l[0], l[1], l[2]}, {v, l[2], l[3], l[4]}, {v, l[4], l[5], l[0]}};
  ASSERT_EQ(mesh.replace_veto(disc.faces, quads), Veto::kNone);
  mesh.replace(disc.faces, quads);
  EXPECT_VALID(mesh);
  EXPECT_TRUE(mesh.alive(v));
  EXPECT_EQ(mesh.valence(v), 3);
}

TEST(ReplaceFaces, RefusesAnEdgeThatIsOutsideAlready) {
  // Two triangles of a tetrahedron: the other diagonal is an edge of the other two.
  SurfaceMesh mesh;
  std::vector<VertexH> v;
  for (int k = 0; k < 4; ++k) v.push_back(mesh.add_vertex(VertexData()));
  mesh.build({{v[0], v[1], v[2]}, {v[0], v[2], v[3]}, {v[0], v[3], v[1]}, {v[1], v[3], v[2]}});
  const std::vector<std::vector<VertexH>> flipped{{v[0], v[1], v[3]}, {v[1], v[2], v[3]}};
  EXPECT_EQ(mesh.replace_veto({FaceH(0), FaceH(1)}, flipped), Veto::kEdgeExists);
}

}  // namespace
}  // namespace advlayers
