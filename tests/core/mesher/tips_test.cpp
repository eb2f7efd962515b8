// Corners of the CAD below 40 degrees: no angle of the mesh is much less than the corner's own.
#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

class Tips : public testing::TestWithParam<double> {};

TEST_P(Tips, AreClosedAtTheirOwnAngle) {
  const double corner = GetParam(), half = 0.5 * corner * kDegree;
  const double x = 60 * std::cos(half), y = 60 * std::sin(half);
  const Model model = model_of(polygon_face({{0, 0}, {x, -y}, {x, y}}));
  for (const double height : {0.1, 0.5}) {
    Settings settings = settings_of(8.0);
    settings.first_height = height;
    const MeshResult mesh = mesh_of(model, settings);
    EXPECT_EQ(mesh.figures.inverted, 0);
    EXPECT_GE(mesh.figures.min_angle, std::min(0.9 * corner, 20.0)) << height;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Tips, testing::Values(1.0, 3.0, 6.0, 7.9, 15.0, 24.0));

}  // namespace
}  // namespace advlayers::test
