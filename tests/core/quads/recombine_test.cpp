#include "quads/recombine.h"

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include "base/error.h"
#include "core/fill_core.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"
#include "measure/patch_fixture.h"
#include "quads/triangle_walk.h"

namespace advlayers::test {
namespace {

struct Case {
  const char* name;
  TopoDS_Shape shape;
  double size;
  int euler;
};

std::vector<Case> cases() {
  return {{"plane", BRepPrimAPI_MakeBox(10, 8, 6).Shape(), 0.4, 1},
          {"cylinder", BRepPrimAPI_MakeCylinder(4, 9).Shape(), 0.6, 0},
          {"sphere", BRepPrimAPI_MakeSphere(5).Shape(), 0.5, 2},
          {"torus", BRepPrimAPI_MakeTorus(9, 3).Shape(), 0.8, 0}};
}

void fill(TriangulatedFace& face) {
  fill_core(face.context, face.mesh, face.surface, face.evaluator, face.settings);
}

class CoreOf : public testing::TestWithParam<Case> {};

TEST_P(CoreOf, FillingKeepsTheMeshSoundAndItsFrozenEdges) {
  TriangulatedFace face(GetParam().shape, GetParam().size);
  const auto frozen = frozen_edges(face.mesh);
  const double before = angle_shares(face.mesh).min_angle;
  face.settings.core = CoreElements::kTriangles;
  fill(face);
  expect_sound(face, GetParam().euler);
  EXPECT_EQ(frozen_edges(face.mesh), frozen);
  EXPECT_GE(angle_shares(face.mesh).min_angle, std::min(before, 30.0));
}

TEST_P(CoreOf, RecombinationGivesNearlyAllQuadsWithGoodAngles) {
  TriangulatedFace face(GetParam().shape, GetParam().size);
  const auto frozen = frozen_edges(face.mesh);
  fill(face);
  recombine(face.context, face.mesh, face.surface);
  expect_sound(face, GetParam().euler);
  EXPECT_EQ(frozen_edges(face.mesh), frozen);
  const AngleShares shares = angle_shares(face.mesh);
  EXPECT_GT(shares.quads, 0.98);
  EXPECT_GT(shares.good_angles, 0.98);
  EXPECT_GT(shares.min_angle, 20.0);
  EXPECT_LT(shares.max_angle, 160.0);
}

TEST_P(CoreOf, RecombinationIsTheSameEveryTime) {
  std::array<std::vector<double>, 2> places;
  for (auto& values : places) {
    TriangulatedFace face(GetParam().shape, GetParam().size);
    fill(face);
    recombine(face.context, face.mesh, face.surface);
    for (std::size_t i = 0; i < face.mesh.vertex_capacity(); ++i) {
      for (const double x : face.mesh.position(VertexH(i))) values.push_back(x);
    }
  }
  EXPECT_EQ(places[0], places[1]);
}

INSTANTIATE_TEST_SUITE_P(Faces, CoreOf, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

TEST(Recombine, AsksToStop) {
  TriangulatedFace face(BRepPrimAPI_MakeBox(10, 8, 6).Shape(), 1.0);
  face.context.cancel();
  EXPECT_THROW(fill(face), Cancelled);
  EXPECT_THROW(recombine(face.context, face.mesh, face.surface), Cancelled);
}

TEST(Recombine, KeepsLayerFacesApart) {
  TriangulatedFace face(BRepPrimAPI_MakeBox(10, 8, 6).Shape(), 1.0);
  SurfaceMesh& mesh = face.mesh;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) mesh.data(FaceH(i)).layer = 3;
  EXPECT_TRUE(free_vertices(mesh).empty());
  return_to_core(mesh);
  recombine(face.context, mesh, face.surface);
  return_to_core(mesh);
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    EXPECT_EQ(mesh.data(f).layer, mesh.is_triangle(mesh.halfedge(f)) ? 3 : 0);
  }
}

// A strip of squares with a triangle at either end: the walk has to cross every square.
SurfaceMesh strip_between_triangles(int squares) {
  SurfaceMesh mesh;
  const auto add = [&mesh](double x, double y) {
    VertexData data;
    data.point.xyz = Vec3(x, y, 0.0);
    data.normal = Vec3::UnitZ();
    data.support = Support::kEdge;
    return mesh.add_vertex(data);
  };
  std::vector<VertexH> low, high;
  for (int i = 0; i <= squares; ++i) {
    low.push_back(add(i, 0.0));
    high.push_back(add(i, 1.0));
  }
  const VertexH left = add(-0.8, 0.2), right = add(squares + 0.8, 0.8);
  std::vector<std::vector<VertexH>> faces{{left, low.front(), high.front()},
                                          {low.back(), right, high.back()}};
  for (std::size_t i = 0; i + 1 < low.size(); ++i) {
    faces.push_back({low[i], low[i + 1], high[i + 1], high[i]});
  }
  mesh.build(faces);
  return mesh;
}

class TriangleWalk : public testing::Test {
 protected:
  TriangleWalk()
      : model(model_of(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, -30), 30, 30, 30).Shape())),
        evaluator(model),
        surface(evaluator, {FaceId(5)}) {}

  const Model model;
  Evaluator evaluator;
  PatchSurface surface;
};

TEST_F(TriangleWalk, JoinsTwoTrianglesAcrossQuads) {
  for (const int squares : {1, 2, 5}) {
    SurfaceMesh mesh = strip_between_triangles(squares);
    EXPECT_EQ(join_triangles(RunContext(), mesh, surface), 1);
    EXPECT_EQ(find_connectivity_fault(mesh), "");
    EXPECT_EQ(find_inverted_element(mesh), "");
    EXPECT_EQ(mesh.face_count(), squares + 1);
    EXPECT_EQ(angle_shares(mesh).quads, 1.0);
  }
}

TEST_F(TriangleWalk, StaysWithinFrozenEdges) {
  SurfaceMesh mesh = strip_between_triangles(3);
  const HalfedgeH wall = mesh.find_halfedge(VertexH(4), VertexH(5));
  ASSERT_TRUE(wall.valid());
  mesh.set_frozen(wall, true);
  EXPECT_EQ(join_triangles(RunContext(), mesh, surface), 0);
  EXPECT_EQ(mesh.face_count(), 5);
}

// Two columns begin side by side, below the middle of the row above: the vertex between them lies
// in line with its neighbours until it is moved.
TEST_F(TriangleWalk, OpensTheQuadOfTwoRowEndsInLine) {
  SurfaceMesh mesh;
  const auto add = [&](double x, double y) {
    VertexData data;
    data.point = evaluator.closest(FaceId(5), Vec3(x, y, 0.0));
    data.normal = Vec3::UnitZ();
    data.support = x == 1.0 && y == 1.0 ? Support::kPatch : Support::kEdge;
    return mesh.add_vertex(data);
  };
  const std::vector<VertexH> low{add(0, 0), add(1, 0), add(2, 0)};
  std::array<std::vector<VertexH>, 2> rows;
  for (std::size_t row = 0; row < 2; ++row) {
    for (const double x : {-0.2, 0.4, 1.0, 1.6, 2.2}) {
      rows[row].push_back(add(x, 1.0 + static_cast<double>(row)));
    }
  }
  const std::vector<VertexH>&mid = rows[0], &high = rows[1];
  std::vector<std::vector<VertexH>> faces{{low[0], low[1], mid[1], mid[0]},
                                          {low[1], mid[2], mid[1]},
                                          {low[1], mid[3], mid[2]},
                                          {low[1], low[2], mid[4], mid[3]}};
  for (std::size_t k = 0; k + 1 < mid.size(); ++k) {
    faces.push_back({mid[k], mid[k + 1], high[k + 1], high[k]});
  }
  mesh.build(faces);
  EXPECT_EQ(join_triangles(RunContext(), mesh, surface), 1);
  EXPECT_EQ(find_connectivity_fault(mesh), "");
  EXPECT_EQ(find_inverted_element(mesh), "");
  EXPECT_EQ(angle_shares(mesh).quads, 1.0);
  EXPECT_GT(mesh.position(mid[2]).y(), 1.1);
}

// Nine unit squares on the plane face of a box, with the corners of the middle one displaced.
TEST(StarSmoothing, BringsDisplacedVerticesBack) {
  const Model model = model_of(BRepPrimAPI_MakeBox(gp_Pnt(-9, -9, 0), 30, 30, 30).Shape());
  Evaluator evaluator(model);
  for (std::size_t i = 0; i < model.faces().size(); ++i) {
    const SurfacePoint foot = evaluator.closest(FaceId(i), Vec3(1.5, 1.5, 0.0));
    const Vec3 normal = evaluator.normal(foot);
    if (foot.xyz.z() > 1e-9 || normal.z() > -0.9) continue;
    PatchSurface surface(evaluator, {FaceId(i)});
    SurfaceMesh mesh;
    for (int y = 0; y < 4; ++y) {
      for (int x = 0; x < 4; ++x) {
        VertexData data;
        const bool inner = x % 3 != 0 && y % 3 != 0;
        const Vec3 place = Vec3(x, y, 0.0) + (inner ? Vec3(0.35, 0.2 * x, 0.0) : Vec3::Zero());
        data.point = evaluator.closest(FaceId(i), place);
        data.normal = normal;
        data.support = inner ? Support::kPatch : Support::kEdge;
        mesh.add_vertex(data);
      }
    }
    std::vector<std::vector<VertexH>> faces;
    for (int y = 0; y < 3; ++y) {
      for (int x = 0; x < 3; ++x) {
        const int k = 4 * y + x;  // clockwise from above: the normal points down
        faces.push_back({VertexH(k), VertexH(k + 4), VertexH(k + 5), VertexH(k + 1)});
      }
    }
    mesh.build(faces);
    smooth_stars(RunContext(), mesh, surface, free_vertices(mesh), QuadTarget::kSquare, 50);
    for (const int k : {5, 6, 9, 10}) {
      EXPECT_LT((mesh.position(VertexH(k)) - Vec3(k % 4, k / 4, 0.0)).norm(), 0.03);
    }
    return;
  }
  FAIL() << "the box has no face at z = 0";
}

}  // namespace
}  // namespace advlayers::test
