#include "mesher/curved_element.h"

#include <algorithm>
#include <vector>

namespace advlayers {
namespace {

// Derivatives of all shape functions along both directions at one place of the unit element; the
// mid nodes come after the corners.
struct Slopes {
  std::array<double, 8> x{}, y{};
};

constexpr std::array<Vec2::Scalar, 4> kCornerX{-1, 1, 1, -1}, kCornerY{-1, -1, 1, 1};

// Serendipity quad on [-1, 1] x [-1, 1].
Slopes quad_slopes(double x, double y) {
  Slopes slopes;
  for (std::size_t k = 0; k < 4; ++k) {
    const double a = kCornerX[k], b = kCornerY[k];
    slopes.x[k] = 0.25 * a * (1 + b * y) * (2 * a * x + b * y);
    slopes.y[k] = 0.25 * b * (1 + a * x) * (2 * b * y + a * x);
    const bool along_x = k % 2 == 0;  // the side after this corner
    const double side = along_x ? b : kCornerX[k];
    slopes.x[4 + k] = along_x ? -x * (1 + side * y) : 0.5 * side * (1 - y * y);
    slopes.y[4 + k] = along_x ? 0.5 * side * (1 - x * x) : -y * (1 + side * x);
  }
  return slopes;
}

// Triangle with corners (0, 0), (1, 0), (0, 1).
Slopes triangle_slopes(double x, double y) {
  const double rest = 1 - x - y;
  Slopes slopes;
  slopes.x = {1 - 4 * rest, 4 * x - 1, 0, 4 * (rest - x), 4 * y, -4 * y};
  slopes.y = {1 - 4 * rest, 0, 4 * y - 1, -4 * x, 4 * x, 4 * (rest - y)};
  return slopes;
}

std::vector<Slopes> all_quad_slopes() {
  std::vector<Slopes> all;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = (k + 1) % 4;
    all.push_back(quad_slopes(kCornerX[k], kCornerY[k]));
    all.push_back(
        quad_slopes(0.5 * (kCornerX[k] + kCornerX[next]), 0.5 * (kCornerY[k] + kCornerY[next])));
  }
  all.push_back(quad_slopes(0, 0));
  return all;
}

std::vector<Slopes> all_triangle_slopes() {
  constexpr double kThird = 1.0 / 3.0;  // where all three sides count alike
  return {triangle_slopes(0, 0),          triangle_slopes(1, 0),     triangle_slopes(0, 1),
          triangle_slopes(0.5, 0),        triangle_slopes(0.5, 0.5), triangle_slopes(0, 0.5),
          triangle_slopes(kThird, kThird)};
}

double jacobian(const CurvedElement& element, const std::array<Vec3, 4>& mids, const Slopes& slopes,
                const Vec3& normal) {
  Vec3 along = Vec3::Zero(), up = Vec3::Zero();
  const auto count = static_cast<std::size_t>(element.count);
  for (std::size_t k = 0; k < count; ++k) {
    along += slopes.x[k] * element.corners[k] + slopes.x[count + k] * mids[k];
    up += slopes.y[k] * element.corners[k] + slopes.y[count + k] * mids[k];
  }
  return along.cross(up).dot(normal);
}

}  // namespace

double least_jacobian(const CurvedElement& element) {
  static const std::vector<Slopes> kQuad = all_quad_slopes(), kTriangle = all_triangle_slopes();
  const auto& c = element.corners;
  const Vec3 normal = element.count == 4 ? (c[2] - c[0]).cross(c[3] - c[1]).normalized()
                                         : (c[1] - c[0]).cross(c[2] - c[0]).normalized();
  std::array<Vec3, 4> straight;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t next = k + 1 < static_cast<std::size_t>(element.count) ? k + 1 : 0;
    straight[k] = 0.5 * (c[k] + c[next]);
  }
  double least = 1.0;
  for (const Slopes& slopes : element.count == 4 ? kQuad : kTriangle) {
    const double of_straight = jacobian(element, straight, slopes, normal);
    if (!(of_straight > 0.0)) continue;
    least = std::min(least, jacobian(element, element.mids, slopes, normal) / of_straight);
  }
  return least;
}

}  // namespace advlayers
