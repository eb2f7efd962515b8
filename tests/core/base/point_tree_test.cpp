#include "base/point_tree.h"

#include <gtest/gtest.h>

#include <random>

namespace advlayers {
namespace {

TEST(PointTree, FindsWhatATrialOfAllFinds) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  std::vector<Vec3> points;
  for (int i = 0; i < 500; ++i) points.emplace_back(part(random), part(random), 0.1 * part(random));
  const PointTree tree(RunContext(), points);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p(1.5 * part(random), 1.5 * part(random), part(random));
    double least = (points.front() - p).norm();
    for (const Vec3& q : points) least = std::min(least, (q - p).norm());
    EXPECT_EQ((points[static_cast<std::size_t>(tree.nearest(p))] - p).norm(), least);
  }
}

TEST(PointTree, CopesWithNoneOneAndEqualPoints) {
  EXPECT_EQ(PointTree().nearest(Vec3::Zero()), -1);
  EXPECT_EQ(PointTree(RunContext(), {Vec3(1, 2, 3)}).nearest(Vec3::Zero()), 0);
  const PointTree equal(RunContext(), std::vector<Vec3>(9, Vec3(1, 1, 1)));
  EXPECT_GE(equal.nearest(Vec3::Zero()), 0);
}

}  // namespace
}  // namespace advlayers
