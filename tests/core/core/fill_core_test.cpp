// The core made anew: in rows and columns from its border.
#include "core/fill_core.h"

#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "measure/core_region.h"
#include "measure/patch_fixture.h"
#include "quads/recombine.h"

namespace advlayers::test {
namespace {

// A rectangle in the plane z = 0, with a round hole in its middle if `radius` > 0.
TopoDS_Shape plate(double length, double width, double radius = 0.0) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(length, width, 1.0).Shape();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(block, TopAbs_FACE, faces);
  if (radius == 0.0) return faces(5);
  const gp_Ax2 axis(gp_Pnt(length / 2, width / 2, -1), gp::DZ());
  return BRepAlgoAPI_Cut(faces(5), BRepPrimAPI_MakeCylinder(axis, radius, 3).Shape()).Shape();
}

void fill(TriangulatedFace& face) {
  fill_core(face.context, face.mesh, face.surface, face.evaluator, face.settings);
  recombine(face.context, face.mesh, face.surface);
}

// The part of the vertices inside that do not have four quads about them.
double irregular_share(const SurfaceMesh& mesh) {
  const std::vector<VertexH> free = free_vertices(mesh);
  double irregular = 0.0;
  for (const VertexH v : free) {
    int quads = 0, triangles = 0;
    const HalfedgeH first = mesh.outgoing(v);
    HalfedgeH h = first;
    do {
      ++(mesh.is_triangle(h) ? triangles : quads);
      h = mesh.rotate_cw(h);
    } while (h != first);
    irregular += quads != 4 || triangles != 0;
  }
  return irregular / static_cast<double>(free.size());
}

TEST(FillCore, MakesAPlainGridOfARectangle) {
  TriangulatedFace face(plate(20, 10), 0.5);
  fill(face);
  expect_sound(face, 1);
  EXPECT_EQ(angle_shares(face.mesh).quads, 1.0);
  EXPECT_LE(irregular_share(face.mesh), 0.01);
}

struct Case {
  const char* name;
  TopoDS_Shape shape;
  double size, most_irregular;
};

class Irregular : public testing::TestWithParam<Case> {};

// An isotropic triangulation that is paired has 20 to 30 % of them.
TEST_P(Irregular, VerticesAreFew) {
  TriangulatedFace face(GetParam().shape, GetParam().size);
  fill(face);
  EXPECT_LE(irregular_share(face.mesh), GetParam().most_irregular);
  EXPECT_GE(angle_shares(face.mesh).quads, 0.98);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Irregular,
    testing::Values(Case{"plate_with_hole", plate(20, 20, 4), 0.5, 0.14},
                    Case{"sphere", BRepPrimAPI_MakeSphere(10).Shape(), 1.0, 0.16},
                    Case{"torus", BRepPrimAPI_MakeTorus(10, 4).Shape(), 0.9, 0.14}),
    [](const auto& tested) { return std::string(tested.param.name); });

// However the width fits the size: no row of half a height is left in the middle.
TEST(FillCore, DividesANarrowRoomIntoEvenRows) {
  for (const double width : {1.3, 1.7, 2.3, 2.6, 3.4}) {
    TriangulatedFace face(plate(30, width), 1.0);
    fill(face);
    expect_sound(face, 1);
    double rows = -1;
    for (std::size_t i = 0; i < face.mesh.vertex_capacity(); ++i) {
      const VertexH v(i);
      rows += face.mesh.alive(v) && std::abs(face.mesh.position(v).x()) < 1e-9;
    }
    for (const VertexH v : free_vertices(face.mesh)) {
      const double row = face.mesh.position(v).y() / width * rows;
      EXPECT_NEAR(row, std::round(row), 0.2) << "width " << width;
    }
    EXPECT_GE(angle_shares(face.mesh).quads, 0.95) << "width " << width;
  }
}

TEST(FillCore, AsksToStop) {
  TriangulatedFace face(plate(20, 10), 0.5);
  face.context.cancel();
  EXPECT_THROW(fill(face), Cancelled);
}

}  // namespace
}  // namespace advlayers::test
