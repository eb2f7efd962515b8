// Two faces of a lens share their whole boundary, so both may join the same two of its nodes.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeSphere.hxx>
#include <gp_Ax2.hxx>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

class CoarseLens : public testing::TestWithParam<CoreElements> {};

TEST_P(CoarseLens, IsWatertight) {
  const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  const Model model = model_of(BRepPrimAPI_MakeSphere(axis, 10, 70 * M_PI / 180, M_PI / 2).Shape());
  ASSERT_TRUE(model.closed());
  Settings settings = test::coarse_settings();
  settings.curvature_angle = 60.0;
  settings.core = GetParam();
  for (const double size : {3.5, 4.5, 6.0, 8.0}) {
    for (const double height : {0.3, 1.0, 3.0}) {
      settings.size = size;
      settings.first_height = height;
      SCOPED_TRACE(testing::Message() << size << " mm, first height " << height << " mm");
      const MeshResult mesh = mesh_of(model, settings);
      expect_watertight(mesh);
      EXPECT_EQ(mesh.figures.inverted, 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfElements, CoarseLens,
                         testing::Values(CoreElements::kQuads, CoreElements::kTriangles));

}  // namespace
}  // namespace advlayers::test
