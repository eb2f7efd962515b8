#include "base/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace advlayers {
namespace {

// For whole numbers below 2^52: the determinant fits 128 bits.
int integer_orient(const Vec2& a, const Vec2& b, const Vec2& c) {
  using Wide = __int128;
  const auto whole = [](double x) { return static_cast<Wide>(static_cast<std::int64_t>(x)); };
  const Wide det = (whole(a.x()) - whole(c.x())) * (whole(b.y()) - whole(c.y())) -
                   (whole(a.y()) - whole(c.y())) * (whole(b.x()) - whole(c.x()));
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

TEST(Orient2d, TellsTheThreeCases) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

TEST(Orient2d, IsExactNearALine) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-4e15, 4e15), along(0, 1);
  std::uniform_int_distribution<int> off(-2, 2);
  const auto rounded = [](const Vec2& p) { return Vec2(std::round(p.x()), std::round(p.y())); };
  std::array<int, 3> seen{};
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a = rounded({coordinate(random), coordinate(random)});
    const Vec2 b = i % 3 ? rounded({coordinate(random), coordinate(random)}) : Vec2(-a);
    const Vec2 c = rounded((a + along(random) * (b - a)) / 2) * 2 + Vec2(off(random), off(random));
    const int expected = integer_orient(a, b, c);
    ++seen[static_cast<std::size_t>(expected + 1)];
    ASSERT_EQ(orient2d(a, b, c), expected) << a << b << c;
    ASSERT_EQ(orient2d(b, a, c), -expected);
    ASSERT_EQ(orient2d(c, a, b), expected);
    const Vec2 middle = rounded(a / 2);  // on the line through a and 2 * middle, exactly
    ASSERT_EQ(orient2d(Vec2(0, 0), 2 * middle, middle), 0);
  }
  EXPECT_GT(seen[0], 1000);
  EXPECT_GT(seen[2], 1000);
}

TEST(SurelyInCircle, SaysNoOnTheCircleAndOutside) {
  const Vec2 a(0, 0), b(1, 0), c(0, 1);
  EXPECT_TRUE(surely_in_circle(a, b, c, {0.5, 0.5}));
  EXPECT_FALSE(surely_in_circle(a, b, c, {1, 1}));
  EXPECT_FALSE(surely_in_circle(a, b, c, {2, 2}));
}

// Both diagonals of a quad may never be refused at once for the other: flips would not end.
TEST(SurelyInCircle, NeverFlipsBackAndForth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 6.28318);
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 4> t{angle(random), angle(random), angle(random), angle(random)};
    std::sort(t.begin(), t.end());
    std::array<Vec2, 4> p;
    for (int k = 0; k < 4; ++k) p[k] = Vec2(1e3 + std::cos(t[k]), -1e3 + std::sin(t[k]));
    const bool flip_first = surely_in_circle(p[0], p[1], p[2], p[3]);
    const bool flip_second = surely_in_circle(p[1], p[2], p[3], p[0]);
    ASSERT_FALSE(flip_first && flip_second);
  }
}

}  // namespace
}  // namespace advlayers
