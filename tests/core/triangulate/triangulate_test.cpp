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
#include "triangulate/cut_edges.h"
#include "triangulate/mesh_properties.h"

namespace advlayers {
namespace {

using namespace test;

// Meshes every face of a shape as a patch of its own, and expects what every patch has to fulfil.
struct FaceByFace {
  explicit FaceByFace(const TopoDS_Shape& shape, double size)
      : model(model_of(shape)), evaluator(model) {
    settings.size = size;
    cut = cut_edges(evaluator, size, settings.curvature_angle);
  }

  Triangulation mesh(FaceId face) {
    PatchSurface surface(evaluator, {face});
    return triangulate(surface, evaluator, cut, settings, CancelFlag());
  }

  // Euler numbers by face.
  void expect(const std::vector<int>& euler, const Expected& expected = {}) {
    ASSERT_EQ(model.faces().size(), euler.size());
    for (std::size_t i = 0; i < euler.size(); ++i) {
      SCOPED_TRACE(face_name(FaceId(i)));
      PatchSurface surface(evaluator, {FaceId(i)});
      const Triangulation made = triangulate(surface, evaluator, cut, settings, CancelFlag());
      EXPECT_TRUE(made.diagnostics.empty());
      expect_sound(made, surface, evaluator, cut, settings, euler[i], expected);
    }
  }

  Model model;
  Evaluator evaluator;
  Settings settings;
  Discretization cut;
};

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
  FaceByFace(BRepPrimAPI_MakeSphere(10).Shape(), 1.5).expect({2}, {20 * kDegree});
}

TEST(Triangulate, MeshesATorus) { FaceByFace(BRepPrimAPI_MakeTorus(10, 3).Shape(), 1).expect({0}); }

}  // namespace
}  // namespace advlayers
