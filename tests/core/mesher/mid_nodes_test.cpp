#include "mesher/mid_nodes.h"
#include "mesher/curved_element.h"

#include <BRepPrimAPI_MakeSphere.hxx>

#include "geometry/shapes.h"
#include "mesh_of.h"

namespace advlayers {
namespace {

CurvedElement unit_square() {
  CurvedElement element;
  element.count = 4;
  element.corners = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  for (std::size_t k = 0; k < 4; ++k) {
    element.mids[k] = 0.5 * (element.corners[k] + element.corners[(k + 1) % 4]);
  }
  return element;
}

TEST(CurvedElement, StraightSidesLeaveTheJacobianAsItIs) {
  EXPECT_DOUBLE_EQ(least_jacobian(unit_square()), 1.0);
  CurvedElement triangle = unit_square();
  triangle.count = 3;
  triangle.mids[2] = 0.5 * (triangle.corners[2] + triangle.corners[0]);
  EXPECT_NEAR(least_jacobian(triangle), 1.0, 1e-15);
}

// A side bent inward by b: d(y)/d(eta) at its corners is 1 - 4 b along the side's quarter slope.
TEST(CurvedElement, ABendTowardsTheOppositeSideTakesFromIt) {
  double before = 1.0;
  for (const double bend : {0.1, 0.2, 0.3, 0.4}) {
    CurvedElement element = unit_square();
    element.mids[0].y() += bend;
    const double now = least_jacobian(element);
    EXPECT_LT(now, before);
    before = now;
  }
  CurvedElement through = unit_square();
  through.mids[0].y() += 1.2;
  EXPECT_LT(least_jacobian(through), 0.0);
}

// A mid node a quarter of the side off its middle makes the mapping singular at the corner.
TEST(CurvedElement, AQuarterPointIsTheLimitAlongASide) {
  CurvedElement element = unit_square();
  element.mids[0].x() = 0.25;
  EXPECT_NEAR(least_jacobian(element), 0.0, 1e-14);
}

TEST(MidNodes, LieOnASphereAndAreShared) {
  const Model model = test::model_of(BRepPrimAPI_MakeSphere(5.0).Shape());
  Settings settings = test::settings_of(1.0);
  settings.order = 2;
  const MeshResult mesh = test::mesh_of(model, settings);
  EXPECT_EQ(mesh.mid_nodes.size(), test::uses_of_edges(mesh).size());
  for (const Vec3& node : mesh.mid_nodes) EXPECT_NEAR(node.norm(), 5.0, 1e-12);
}

}  // namespace
}  // namespace advlayers
