// A shape that is turned, moved and scaled gets the same elements, the nodes with it.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Trsf.hxx>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

TopoDS_Shape drilled_box() {
  const gp_Ax2 axis(gp_Pnt(4, 3, -1), gp::DZ());
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(10, 7, 4).Shape(),
                         BRepPrimAPI_MakeCylinder(axis, 1.3, 9).Shape())
      .Shape();
}

struct MovedShape {
  const char* name;
  TopoDS_Shape shape;
  double size;
};

class Invariance : public testing::TestWithParam<double> {};

TEST_P(Invariance, ElementsStayAndNodesFollow) {
  const double scale = GetParam();
  gp_Trsf turn, shift, grow;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -0.4)), 1.1);
  shift.SetTranslation(gp_Vec(31, -8, 5.5));
  grow.SetScale(gp_Pnt(), scale);
  const gp_Trsf motion = grow * shift * turn;
  for (const auto& [name, shape, size] :
       {MovedShape{"drilled box", drilled_box(), 0.7},
        MovedShape{"frustum", BRepPrimAPI_MakeCone(4, 2, 5).Shape(), 0.6}}) {
    SCOPED_TRACE(name);
    Settings settings = test::coarse_settings();
    settings.size = size;
    settings.first_height = 0.1 * size;
    const MeshResult here = mesh_of(model_of(shape), settings);
    settings.size *= scale;
    settings.first_height *= scale;
    const MeshResult there =
        mesh_of(model_of(BRepBuilderAPI_Transform(shape, motion, true).Shape()), settings);
    EXPECT_EQ(here.quads, there.quads);
    EXPECT_EQ(here.triangles, there.triangles);
    ASSERT_EQ(here.nodes.size(), there.nodes.size());
    for (std::size_t i = 0; i < here.nodes.size(); ++i) {
      const gp_Pnt image =
          gp_Pnt(here.nodes[i].x(), here.nodes[i].y(), here.nodes[i].z()).Transformed(motion);
      EXPECT_NEAR((there.nodes[i] - Vec3(image.X(), image.Y(), image.Z())).norm(), 0.0,
                  1e-6 * scale);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, Invariance, testing::Values(1.0, 1000.0, 0.1));

}  // namespace
}  // namespace advlayers::test
