#include "triangulate/triangulate.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gp_Ax2.hxx>

#include "geometry/shapes.h"
#include "triangulate/face_by_face.h"

namespace advlayers {
namespace {

using namespace test;

TEST(Triangulate, MeshesABox) {
  FaceByFace(BRepPrimAPI_MakeBox(10, 20, 30).Shape(), 2).expect({1, 1, 1, 1, 1, 1});
}

TEST(Triangulate, MeshesABoxInOnePieceEach) {
  FaceByFace(BRepPrimAPI_MakeBox(10, 11, 12).Shape(), 100).expect({1, 1, 1, 1, 1, 1});
}

TEST(Triangulate, MeshesACylinder) {
  FaceByFace(BRepPrimAPI_MakeCylinder(10, 30).Shape(), 2).expect({0, 1, 1});
}

TEST(Triangulate, MeshesASphere) {
  FaceByFace(BRepPrimAPI_MakeSphere(10).Shape(), 1.5).expect({2});
}

TEST(Triangulate, MeshesATorus) { FaceByFace(BRepPrimAPI_MakeTorus(10, 3).Shape(), 1).expect({0}); }

TEST(Triangulate, MeshesACone) {
  FaceByFace(BRepPrimAPI_MakeCone(10, 4, 20).Shape(), 1.5).expect({0, 1, 1});
}

TEST(Triangulate, KeepsTheApexOfACone) {
  FaceByFace cone(BRepPrimAPI_MakeCone(10, 0, 20).Shape(), 1.5);
  cone.expect({1, 1});
  const Triangulation made = cone.mesh(FaceId(0));
  const Vec3 apex(0, 0, 20);
  int found = 0;
  for (std::size_t i = 0; i < made.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!made.mesh.alive(v) || (made.mesh.position(v) - apex).norm() > 1e-9) continue;
    ++found;
    EXPECT_EQ(made.mesh.data(v).support, Support::kVertex);
    EXPECT_FALSE(made.mesh.is_border(v));
    EXPECT_TRUE(made.mesh.data(v).node.valid());
  }
  EXPECT_EQ(found, 1);
}

TEST(Triangulate, MeshesHalfASphere) {
  FaceByFace(BRepPrimAPI_MakeSphere(10, 0.0, M_PI / 2).Shape(), 1.5).expect({1, 1});
}

TEST(Triangulate, MeshesAPlateWithHoles) {
  TopoDS_Shape plate = BRepPrimAPI_MakeBox(40, 30, 2).Shape();
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 3; ++j) {
      const gp_Ax2 axis(gp_Pnt(5 + 10 * i, 5 + 10 * j, -1), gp_Dir(0, 0, 1));
      plate = BRepAlgoAPI_Cut(plate, BRepPrimAPI_MakeCylinder(axis, 1.0 + i, 5).Shape()).Shape();
    }
  }
  FaceByFace faces(plate, 1.5);
  ASSERT_EQ(faces.model.faces().size(), 18u);
  std::vector<int> euler;
  for (const Face& face : faces.model.faces()) {
    euler.push_back(face.kind == SurfaceKind::kCylinder ? 0
                                                        : 2 - static_cast<int>(face.loops.size()));
  }
  faces.expect(euler);
}

TEST(Triangulate, ServesAnyScale) {
  for (const double scale : {1e-3, 1e4}) {
    SCOPED_TRACE(scale);
    FaceByFace(BRepPrimAPI_MakeCylinder(10 * scale, 30 * scale).Shape(), 3 * scale)
        .expect({0, 1, 1});
  }
}

TEST(Triangulate, GivesTheSameMeshAgain) {
  FaceByFace torus(BRepPrimAPI_MakeTorus(10, 3).Shape(), 1);
  const Triangulation first = torus.mesh(FaceId(0)), second = torus.mesh(FaceId(0));
  const auto a = triangles_of(first.mesh), b = triangles_of(second.mesh);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(a[i].x[k], b[i].x[k]);
  }
}

TEST(Triangulate, StopsWhenAsked) {
  FaceByFace sphere(BRepPrimAPI_MakeSphere(10).Shape(), 1);
  PatchSurface surface(sphere.evaluator, {FaceId(0)});
  RunContext context;
  context.cancel();
  EXPECT_THROW(triangulate(context, surface, sphere.evaluator, sphere.cut, sphere.settings),
               Cancelled);
}

}  // namespace
}  // namespace advlayers
