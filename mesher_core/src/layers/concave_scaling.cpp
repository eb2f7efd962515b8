#include "layers/concave_scaling.h"

#include <algorithm>
#include <cmath>

#include "layers/corner_class.h"

namespace advlayers {
namespace {

constexpr double kMostConvex = 1.5;  // a sharper corner would throw its kid too far ahead

}  // namespace

double concave_factor(const NodeShape& shape, double height) {
  if (std::abs(shape.turn()) < kRegularTurn) return 1.0;
  const double parallel = 1.0 / std::sin(0.5 * shape.angle);
  if (shape.turn() < 0.0) return std::min(parallel, kMostConvex);
  return std::min(parallel, std::max(1.0, shape.shorter() / height));
}

}  // namespace advlayers
