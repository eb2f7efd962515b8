// Angles between directions in space.
#pragma once

#include <cmath>

#include "base/types.h"

namespace advlayers {

// The angle [rad] in 0 … pi between two vectors, exact also where they are nearly parallel.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace advlayers
