#include "layers/concave_scaling.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kLeastTurn = 20.0 * M_PI / 180.0;
constexpr double kMostConvex = 1.5;  // a sharper corner would throw its kid too far ahead
// Eq. 9 grows without bound as A nears cot theta; the cell stays convex below this multiple.
constexpr double kMostRace = 1.0;

}  // namespace

double concave_factor(const NodeShape& shape, double height) {
  if (std::abs(shape.turn()) < kLeastTurn) return 1.0;
  const double theta = 0.5 * shape.angle;
  const double parallel = 1.0 / std::sin(theta);
  if (shape.turn() < 0.0) return std::min(parallel, kMostConvex);
  double factor = parallel;
  const double a1 = shape.length_next / height, a2 = shape.length_prev / height;
  const double tangent = std::tan(theta);
  if (a1 * tangent > 1.0 && a2 * tangent > 1.0) {
    factor = 0.5 * parallel * (2.0 + 1.0 / (a1 * tangent - 1.0) + 1.0 / (a2 * tangent - 1.0));
  }
  factor = std::min(factor, kMostRace * parallel);
  return std::min(factor, std::max(1.0, shape.shorter() / height));
}

}  // namespace advlayers
