#include "boundary/match_end.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace advlayers::test {
namespace {

LayerSeries series(double height, double growth, double most = 1.0) {
  LayerSeries s;
  s.height = height;
  s.growth = growth;
  s.most = most;
  return s;
}

double sum(const std::vector<double>& segments) {
  return std::accumulate(segments.begin(), segments.end(), 0.0);
}

TEST(LayersAlong, GrowByTheSineOfTheAngle) {
  LayerSeries s = series(0.1, 1.2);
  s.layers = 7;
  s.sine = std::sin(M_PI / 3);
  const LayeredCuts cuts = lay_out_layers(20.0, {s}, {});
  ASSERT_EQ(cuts.segments[0].size(), 7u);
  EXPECT_TRUE(cuts.segments[1].empty());
  EXPECT_FALSE(cuts.closed);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_NEAR(cuts.segments[0][k], 0.1 * std::pow(1.2, k) / s.sine, 1e-12);
  }
}

TEST(LayersAlong, StopAtTheirBounds) {
  LayerSeries s = series(0.1, 1.5, 0.3);
  const LayeredCuts capped = lay_out_layers(5.0, {s}, {});
  for (const double segment : capped.segments[0]) EXPECT_LE(segment, 0.3 + 1e-12);
  s = series(0.1, 1.5);
  s.isotropic = 0.4;
  EXPECT_EQ(lay_out_layers(5.0, {s}, {}).segments[0].size(), 4u);  // 0.1 … 0.3375
}

// What is left of the edge is too short for another layer, and no layer passed the middle.
TEST(LayersAlong, MeetInTheMiddle) {
  for (const double length : {1.0, 3.7, 9.0}) {
    const LayeredCuts cuts = lay_out_layers(length, {series(0.1, 1.2)}, {series(0.1, 1.2)});
    EXPECT_TRUE(cuts.closed);
    EXPECT_EQ(cuts.segments[0].size(), cuts.segments[1].size());
    const double rest = length - sum(cuts.segments[0]) - sum(cuts.segments[1]);
    EXPECT_GT(rest, 0.0);
    EXPECT_LT(rest, 2.0 * 1.2 * cuts.segments[0].back() * 1.2);
  }
}

TEST(LayersAlong, TakeTheMeanOfTwoFaces) {
  LayerSeries low = series(0.1, 1.2), high = series(0.2, 1.2);
  low.layers = high.layers = 3;
  const LayeredCuts cuts = lay_out_layers(20.0, {low, high}, {});
  ASSERT_EQ(cuts.segments[0].size(), 3u);
  EXPECT_NEAR(cuts.segments[0][0], 0.15, 1e-12);
  EXPECT_NEAR(cuts.spread, 0.5, 1e-12);  // of the lower one
}

TEST(LayersAlong, NeedRoom) {
  const LayeredCuts cuts = lay_out_layers(0.15, {series(0.1, 1.2)}, {});
  EXPECT_TRUE(cuts.segments[0].empty());
}

}  // namespace
}  // namespace advlayers::test
