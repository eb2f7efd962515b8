// Angles between directions in space.
#pragma once

#include <cmath>

#include "base/types.h"

namespace advlayers {

// The angle [rad] in 0 … pi between two vectors, exact also where they are nearly parallel.
inline double angle_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The angle [rad] in 0 … 2 pi from direction `from` counter-clockwise to `to` about `normal`.
inline double turn_angle(const Vec3& from, const Vec3& to, const Vec3& normal) {
  const double angle =
      std::atan2(from.cross(to).dot(normal), from.dot(to) - from.dot(normal) * to.dot(normal));
  return angle < 0.0 ? angle + 2.0 * M_PI : angle;
}

}  // namespace advlayers
