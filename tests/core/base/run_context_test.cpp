#include "base/run_context.h"

#include <gtest/gtest.h>

namespace advlayers {
namespace {

TEST(RunContext, TimesItsStagesByItsClock) {
  double now = 0.0;
  const RunContext context([&now] { return now; });
  {
    const StageScope stage(context, RunStage::kRead);
    now += 2.0;
  }
  for (int layer = 0; layer < 3; ++layer) {
    const StageScope stage(context, RunStage::kLayers);
    now += 0.5;
  }
  EXPECT_EQ(context.seconds(RunStage::kRead), 2.0);
  EXPECT_EQ(context.seconds(RunStage::kLayers), 1.5);
  EXPECT_EQ(context.seconds(RunStage::kCore), 0.0);
}

TEST(RunContext, SharesRiseWithinAStageAndBeginAnewWithTheNext) {
  const RunContext context;
  EXPECT_EQ(context.progress().stage, RunStage::kNone);
  {
    const StageScope stage(context, RunStage::kTriangulate);
    context.tell_share(0.5);
    context.tell_share(0.25);
    EXPECT_EQ(context.progress().share, 0.5);
    context.tell_share(7.0);
    EXPECT_EQ(context.progress().share, 1.0);
  }
  const StageScope stage(context, RunStage::kLayers);
  EXPECT_EQ(context.progress().stage, RunStage::kLayers);
  EXPECT_EQ(context.progress().share, 0.0);
}

TEST(RunContext, StopsForGood) {
  RunContext context;
  EXPECT_NO_THROW(context.check());
  context.cancel();
  EXPECT_TRUE(context.cancelled());
  EXPECT_THROW(context.check(), Cancelled);
  EXPECT_THROW(context.check(), Cancelled);
}

}  // namespace
}  // namespace advlayers
