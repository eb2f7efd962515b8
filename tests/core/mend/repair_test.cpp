#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>

#include <set>

#include "measure/element_measures.h"
#include "measure/patch_fixture.h"
#include "mend/inversion.h"
#include "quads/seam_repair.h"

namespace advlayers::test {
namespace {

// Meshes by hand on the plane z = 0, which is a face of a box; its outward normal points down, so
// that elements are given clockwise as drawn.
class OnPlane : public testing::Test {
 protected:
  OnPlane()
      : model(model_of(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, 0), 30, 30, 30).Shape())),
        evaluator(model),
        face(bottom()),
        surface(evaluator, {face}) {}

  FaceId bottom() {
    for (std::size_t i = 0; i < model.faces().size(); ++i) {
      const SurfacePoint foot = evaluator.closest(FaceId(i), Vec3(1, 1, 0));
      if (foot.xyz.norm() < 2 && evaluator.normal(foot).z() < -0.9) return FaceId(i);
    }
    throw std::logic_error("the box has no bottom");
  }

  SurfaceMesh mesh_of(const std::vector<std::array<double, 2>>& places,
                      const std::vector<std::vector<int>>& faces) {
    SurfaceMesh mesh;
    for (const auto& [x, y] : places) {
      VertexData data;
      data.point = evaluator.closest(face, Vec3(x, y, 0));
      data.normal = evaluator.normal(data.point);
      mesh.add_vertex(data);
    }
    std::vector<std::vector<VertexH>> handles;
    for (const auto& corners : faces) {
      auto& list = handles.emplace_back();
      for (const int k : corners) list.emplace_back(k);
    }
    mesh.build(handles);
    return mesh;
  }

  int inverted(const SurfaceMesh& mesh) {
    int count = 0;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      count += mesh.alive(FaceH(i)) && is_inverted(mesh, FaceH(i), surface);
    }
    return count;
  }

  Model model;
  Evaluator evaluator;
  FaceId face;
  PatchSurface surface;
};

//  Vertex 1 lies beyond the diagonal (0, 2): the triangle (0, 1, 2) is turned over.
TEST_F(OnPlane, AFlipMendsAnInvertedTriangle) {
  SurfaceMesh mesh = mesh_of({{0, 0}, {1.2, 2.8}, {4, 4}, {4, -2}, {-2, 4}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 4, 1}, {1, 4, 2}});
  ASSERT_EQ(inverted(mesh), 0);
  mesh.data(VertexH(1)).point = evaluator.closest(face, Vec3(2.4, 1.6, 0));
  ASSERT_EQ(inverted(mesh), 1);
  EXPECT_EQ(mend_inverted(RunContext(), mesh, surface).left, 0);
  EXPECT_EQ(inverted(mesh), 0);
  EXPECT_EQ(find_connectivity_fault(mesh), "");
}

TEST_F(OnPlane, AReflexQuadIsDivided) {
  SurfaceMesh mesh = mesh_of({{0, 0}, {1, 1}, {0, 4}, {4, 0}}, {{0, 2, 1, 3}});
  ASSERT_GT(angle_shares(mesh).max_angle, 180.0);
  EXPECT_EQ(mend_inverted(RunContext(), mesh, surface).left, 0);
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_LT(angle_shares(mesh).max_angle, 180.0);
}

TEST_F(OnPlane, SoundMeshesStayAsTheyAre) {
  SurfaceMesh mesh = mesh_of({{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 3}}, {{0, 1, 2, 3}, {1, 4, 2}});
  EXPECT_EQ(mend_inverted(RunContext(), mesh, surface).left, 0);
  EXPECT_EQ(recut_pentagons(RunContext(), mesh), 0);
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_FALSE(mesh.is_triangle(mesh.halfedge(FaceH(0))));
}

//  A triangle flat on the upper side of a square becomes a part of the square, across the front.
TEST_F(OnPlane, AFlatTriangleIsCutIntoTheLayerBelow) {
  SurfaceMesh mesh = mesh_of({{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 2.1}}, {{0, 1, 2, 3}, {1, 4, 2}});
  mesh.set_frozen(mesh.find_halfedge(VertexH(1), VertexH(2)), true);
  const double before = angle_shares(mesh).min_angle;
  ASSERT_LT(before, 10.0);
  EXPECT_EQ(recut_pentagons(RunContext(), mesh), 1);
  EXPECT_GT(angle_shares(mesh).min_angle, 3.0 * before);
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(find_connectivity_fault(mesh), "");
  EXPECT_EQ(inverted(mesh), 0);
}

TEST_F(OnPlane, AFlatTriangleStaysBesideALayerThatIsToStay) {
  SurfaceMesh mesh = mesh_of({{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 2.1}}, {{0, 1, 2, 3}, {1, 4, 2}});
  mesh.data(FaceH(0)).layer = 1;
  EXPECT_EQ(recut_pentagons(RunContext(), mesh, LayerCells::kStay), 0);
  EXPECT_EQ(recut_pentagons(RunContext(), mesh, LayerCells::kTraded), 1);
}

// Vertex 4 is pushed across the side (1, 2) into the quad of a layer.
TEST_F(OnPlane, ALayerThatIsToStayIsCutOnlyWhereAnElementIsTurnedOver) {
  for (const bool turned : {false, true}) {
    SurfaceMesh mesh = mesh_of({{0, 0}, {0, 2}, {2, 2}, {2, 0}, {1, 3}}, {{0, 1, 2, 3}, {1, 4, 2}});
    mesh.data(FaceH(0)).layer = 1;
    mesh.data(VertexH(4)).point = evaluator.closest(face, Vec3(1, turned ? 1.0 : 2.02, 0));
    EXPECT_EQ(inverted(mesh), turned ? 1 : 0);
    const Mended mended = mend_inverted(RunContext(), mesh, surface, LayerCells::kStay);
    EXPECT_EQ(inverted(mesh), 0);
    EXPECT_EQ(mended.of_layers > 0, turned);
  }
}

}  // namespace
}  // namespace advlayers::test
