#include "mend/split_inside.h"

#include <BRepPrimAPI_MakeCylinder.hxx>

#include "measure/patch_fixture.h"
#include "quads/recombine.h"

namespace advlayers::test {
namespace {

// Whether an element beside h has a corner that came with a split.
bool was_split(const SurfaceMesh& mesh, HalfedgeH h, std::size_t vertices_before) {
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    for (const HalfedgeH k : mesh.sides(side)) {
      if (k == side) continue;
      if (mesh.to(k).index() >= vertices_before) return true;
    }
  }
  return false;
}

TEST(SplitInside, KeepsTheMeshSoundBesideAnyElements) {
  TriangulatedFace face(BRepPrimAPI_MakeCylinder(2, 5).Shape(), 0.6);
  const int euler = euler_number(face.mesh);
  recombine(face.context, face.mesh, face.surface);
  int beside_quads = 0;
  const std::size_t count = face.mesh.halfedge_capacity();
  const std::size_t vertices = face.mesh.vertex_capacity();
  for (std::size_t i = 0; i < count; i += 14) {
    const HalfedgeH h(i), t = SurfaceMesh::twin(h);
    if (!face.mesh.alive(h) || face.mesh.is_border(h) || face.mesh.is_border(t)) continue;
    if (was_split(face.mesh, h, vertices)) continue;
    const int quads = !face.mesh.is_triangle(h) + !face.mesh.is_triangle(t);
    const int faces = face.mesh.face_count();
    const VertexH a = face.mesh.from(h), b = face.mesh.to(h);
    face.mesh.set_frozen(h, true);
    const VertexH v = split_inside(face.mesh, face.surface, h);
    ASSERT_TRUE(v.valid());
    beside_quads += quads > 0;
    EXPECT_EQ(face.mesh.face_count(), faces + 2 + quads);
    EXPECT_EQ(face.mesh.valence(v), 4 + quads);
    EXPECT_FALSE(face.mesh.find_halfedge(a, b).valid());
    EXPECT_TRUE(face.mesh.find_halfedge(a, v).valid() && face.mesh.find_halfedge(v, b).valid());
  }
  EXPECT_GT(beside_quads, 0);
  expect_sound(face, euler);
}

}  // namespace
}  // namespace advlayers::test
