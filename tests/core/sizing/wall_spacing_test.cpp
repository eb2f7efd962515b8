#include "sizing/wall_spacing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "coarse_settings.h"

namespace advlayers::test {
namespace {

Settings job() {
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.02;
  settings.growth = 1.25;
  return settings;
}

WallSpec wall() {
  WallSpec spec;
  spec.edges = {EdgeId(2)};
  return spec;
}

std::string refusal(const WallSpec& spec) {
  try {
    spacing_of(spec, job());
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(WallSpacing, TakesTheJobsValuesWhereItHasNone) {
  const WallSpacing spacing = spacing_of(wall(), job());
  EXPECT_EQ(spacing.first_height, 0.02);
  EXPECT_EQ(spacing.growth, 1.25);
  EXPECT_EQ(spacing.layers, kUntilClosed);
}

// Of height, growth, layers and thickness any three give the fourth.
TEST(WallSpacing, ThreeGiveTheFourth) {
  for (const double growth : {1.0, 1.1, 1.7}) {
    const double height = 0.03;
    const int layers = 7;
    const double thickness = thickness_of(height, growth, layers);
    WallSpec spec = wall();
    spec.thickness = thickness;
    spec.first_height = height;
    spec.growth = growth;
    EXPECT_EQ(spacing_of(spec, job()).layers, layers);
    spec.growth.reset();
    spec.layers = layers;
    EXPECT_NEAR(spacing_of(spec, job()).growth, growth, 1e-9);
    spec.first_height.reset();
    spec.growth = growth;
    EXPECT_NEAR(spacing_of(spec, job()).first_height, height, 1e-12);
  }
}

TEST(WallSpacing, ThicknessIsTheSumOfTheHeights) {
  double sum = 0.0;
  for (int k = 0; k < 9; ++k) sum += 0.1 * std::pow(1.3, k);
  EXPECT_NEAR(thickness_of(0.1, 1.3, 9), sum, 1e-12);
  EXPECT_NEAR(thickness_of(0.1, 1.0, 9), 0.9, 1e-15);
}

TEST(WallSpacing, RefusesContradictions) {
  WallSpec four = wall();
  four.first_height = 0.1;
  four.growth = 1.2;
  four.layers = 5;
  four.thickness = 1.0;
  EXPECT_NE(refusal(four).find("one too many"), std::string::npos);
  WallSpec thin = wall();
  thin.thickness = 0.01;
  EXPECT_NE(refusal(thin).find("less than the first height"), std::string::npos);
  WallSpec crowded = wall();
  crowded.first_height = 0.3;
  crowded.layers = 5;
  crowded.thickness = 1.0;
  EXPECT_NE(refusal(crowded).find("no growth"), std::string::npos);
  WallSpec two_heights = wall();
  two_heights.first_height = 0.1;
  two_heights.aspect_ratio = 20;
  EXPECT_NE(refusal(two_heights).find("exclude each other"), std::string::npos);
  WallSpec varying = wall();
  varying.end_height = 0.1;
  varying.thickness = 1.0;
  EXPECT_NE(refusal(varying).find("same along the wall"), std::string::npos);
  WallSpec endless = wall();
  endless.thickness = 1.0;
  endless.layers = 0;
  EXPECT_NE(refusal(endless).find("layers 0"), std::string::npos);
  for (const WallSpec& spec : {four, thin, crowded, two_heights, varying, endless}) {
    EXPECT_NE(refusal(spec).find("Edge3"), std::string::npos);
  }
}

TEST(FirstHeight, FollowsItsRule) {
  WallSpec spec = wall();
  spec.first_height = 0.1;
  spec.end_height = 0.3;
  EXPECT_NEAR(first_height_at(spacing_of(spec, job()), {0.25, 1.0, 0.0}, 9.0), 0.15, 1e-15);
  spec = wall();
  spec.aspect_ratio = 40;
  EXPECT_NEAR(first_height_at(spacing_of(spec, job()), {0.0, 2.0, 0.0}, 9.0), 0.05, 1e-15);
  spec = wall();
  spec.turning_angle = 2;
  const double radius = 5.0;
  EXPECT_NEAR(first_height_at(spacing_of(spec, job()), {0.0, 1.0, 1.0 / radius}, 9.0),
              radius * 2 * M_PI / 180, 1e-12);
  EXPECT_EQ(first_height_at(spacing_of(spec, job()), {0.0, 1.0, 0.0}, 9.0), 9.0);
}

}  // namespace
}  // namespace advlayers::test
