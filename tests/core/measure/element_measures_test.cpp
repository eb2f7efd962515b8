#include "measure/element_measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace advlayers {
namespace {

ElementCorners element(std::initializer_list<Vec3> corners) {
  ElementCorners made;
  for (const Vec3& corner : corners) made.at[static_cast<std::size_t>(made.count++)] = corner;
  return made;
}

TEST(ElementMeasures, AnglesOfAFlatElementSumUp) {
  const auto quad = interior_angles(element({{0, 0, 0}, {3, 0, 0}, {4, 2, 0}, {-1, 3, 0}}));
  EXPECT_NEAR(quad[0] + quad[1] + quad[2] + quad[3], 360.0, 1e-9);
  const auto triangle = interior_angles(element({{0, 0, 0}, {3, 0, 0}, {1, 0, 2}}));
  EXPECT_NEAR(triangle[0] + triangle[1] + triangle[2], 180.0, 1e-9);
}

TEST(ElementMeasures, ACornerThatTurnsBackIsReflex) {
  const auto dart = interior_angles(element({{0, 0, 0}, {4, -1, 0}, {1, 0, 0}, {4, 1, 0}}));
  EXPECT_GT(dart[2], 180.0);
  EXPECT_NEAR(dart[0] + dart[1] + dart[2] + dart[3], 360.0, 1e-9);
}

TEST(ElementMeasures, ARectangleIsTheBestQuad) {
  const Vec3 up = Vec3::UnitZ();
  EXPECT_NEAR(right_angle_quality({0, 0, 0}, {9, 0, 0}, {9, 1, 0}, {0, 1, 0}, up), 1.0, 1e-12);
  const double slant = std::tan(M_PI / 6);
  EXPECT_NEAR(right_angle_quality({0, 0, 0}, {5, 0, 0}, {5 + slant, 1, 0}, {slant, 1, 0}, up), 0.5,
              1e-12);
}

TEST(ElementMeasures, AFoldedQuadIsNegative) {
  const Vec3 a(0, 0, 0), b(4, -1, 0), c(1, 0, 0), d(4, 1, 0);
  EXPECT_LT(right_angle_quality(a, b, c, d, Vec3::UnitZ()), 0.0);
  EXPECT_LT(right_angle_quality({0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, Vec3::UnitZ()), 0.0);
}

TEST(ElementMeasures, SineOfTheSmallestAngle) {
  const Vec3 a(0, 0, 0), b(10, 0, 0), c(10 * std::cos(0.3), 10 * std::sin(0.3), 0);
  EXPECT_NEAR(min_angle_sine(a, b, c, Vec3::UnitZ()), std::sin(0.3), 1e-7);
  EXPECT_NEAR(min_angle_sine(b, c, a, Vec3::UnitZ()), std::sin(0.3), 1e-7);
  EXPECT_NEAR(min_angle_sine(a, c, b, Vec3::UnitZ()), -std::sin(0.3), 1e-7);
}

}  // namespace
}  // namespace advlayers
