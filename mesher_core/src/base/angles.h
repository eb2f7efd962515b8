// Degrees in a core that reckons in radians.
#pragma once

#include <cmath>

namespace advlayers {

inline constexpr double kDegree = M_PI / 180.0;  // [rad]

}  // namespace advlayers
