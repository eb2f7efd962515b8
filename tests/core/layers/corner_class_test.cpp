#include "layers/corner_class.h"

#include <gtest/gtest.h>

#include "layers/growth.h"
#include "layers/patch_layers.h"

namespace advlayers::test {
namespace {

CornerClass at(double degrees) { return corner_class(degrees * kDegree); }

TEST(CornerClass, HasItsBoundsInTheClassFartherFromStraight) {
  EXPECT_EQ(at(0.0), CornerClass::kTip);
  EXPECT_EQ(at(40.0), CornerClass::kTip);
  EXPECT_EQ(at(40.0 + 1e-9), CornerClass::kEnd);
  EXPECT_EQ(at(90.0), CornerClass::kEnd);
  EXPECT_EQ(at(135.0), CornerClass::kEnd);
  EXPECT_EQ(at(135.0 + 1e-9), CornerClass::kSide);
  EXPECT_EQ(at(180.0), CornerClass::kSide);
  EXPECT_EQ(at(247.5 - 1e-9), CornerClass::kSide);
  EXPECT_EQ(at(247.5), CornerClass::kCorner);
  EXPECT_EQ(at(270.0), CornerClass::kCorner);
  EXPECT_EQ(at(315.0 - 1e-9), CornerClass::kCorner);
  EXPECT_EQ(at(315.0), CornerClass::kReversal);
  EXPECT_EQ(at(360.0), CornerClass::kReversal);
}

TEST(CornerClass, RisesWithTheAngle) {
  for (int degrees = 1; degrees <= 360; ++degrees) EXPECT_GE(at(degrees), at(degrees - 1));
}

TEST(LayersRunAlong, UpToTheirBoundsAndNoFarther) {
  for (const double slack : {0.0, kChordSlack}) {
    EXPECT_FALSE(layers_run_along((45.0 - slack - 1e-9) * kDegree, slack));
    EXPECT_TRUE(layers_run_along((45.0 - slack) * kDegree, slack));
    EXPECT_TRUE(layers_run_along((135.0 + slack) * kDegree, slack));
    EXPECT_FALSE(layers_run_along((135.0 + slack + 1e-9) * kDegree, slack));
  }
}

TEST(Growth, TakesOneLayerAfterTheOther) {
  const Growth first{0.5, 2.0, 3};
  const Growth third = first.next().next();
  EXPECT_EQ(third.height, 2.0);
  EXPECT_EQ(third.ratio, 2.0);
  EXPECT_EQ(third.layers_left, 1);
  const Growth both = first.met_by({1.5, 1.0, 2});
  EXPECT_EQ(both.height, 1.0);
  EXPECT_EQ(both.ratio, 1.5);
  EXPECT_EQ(both.layers_left, 2);
}

TEST(LayerSteps, HaveNamesOfTheirOwn) {
  EXPECT_STREQ(step_name(Step::kMakeWay), "make-way");
  EXPECT_STREQ(step_name(Step::kGrow), "grow");
  for (const auto& [id, name] : kVetoes) EXPECT_STRNE(name, "none");
}

}  // namespace
}  // namespace advlayers::test
