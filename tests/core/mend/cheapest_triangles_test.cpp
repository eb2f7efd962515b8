#include "mend/cheapest_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace advlayers {
namespace {

using Triangle = std::array<VertexH, 3>;

double sum_of(const std::vector<std::vector<VertexH>>& triangles,
              const std::function<double(const Triangle&)>& cost) {
  double sum = 0.0;
  for (const auto& t : triangles) sum += cost({t[0], t[1], t[2]});
  return sum;
}

// The least sum by trying everything.
double least_of_all(std::vector<VertexH> polygon,
                    const std::function<double(const Triangle&)>& cost) {
  if (polygon.size() == 3) return cost({polygon[0], polygon[1], polygon[2]});
  double least = INFINITY;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const std::vector<VertexH> left(polygon.begin(), polygon.begin() + static_cast<long>(k) + 1);
    const std::vector<VertexH> right(polygon.begin() + static_cast<long>(k), polygon.end());
    double sum = cost({polygon.front(), polygon[k], polygon.back()});
    if (left.size() > 2) sum += least_of_all(left, cost);
    if (right.size() > 2) sum += least_of_all(right, cost);
    least = std::min(least, sum);
  }
  return least;
}

TEST(CheapestTriangles, CutAPolygonWithTheLeastSum) {
  std::mt19937 random(7);
  for (int n = 3; n <= 8; ++n) {
    std::vector<VertexH> polygon;
    for (int k = 0; k < n; ++k) polygon.emplace_back(10 * k);
    const int salt = static_cast<int>(random() % 1000);
    const auto cost = [salt](const Triangle& t) {
      return static_cast<double>((t[0].value * 31 + t[1].value * 17 + t[2].value * 7 + salt) % 23);
    };
    const auto triangles = cheapest_triangles(polygon, cost);
    EXPECT_EQ(triangles.size(), static_cast<std::size_t>(n - 2));
    EXPECT_DOUBLE_EQ(sum_of(triangles, cost), least_of_all(polygon, cost));
  }
}

}  // namespace
}  // namespace advlayers
