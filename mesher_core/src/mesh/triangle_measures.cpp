#include "mesh/triangle_measures.h"

#include <algorithm>
#include <cmath>

#include "base/directions.h"

namespace advlayers {

double signed_area2(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3 normal = a.normal + b.normal + c.normal;
  const double length = normal.norm();
  if (length == 0.0) return 0.0;
  return (b.xyz - a.xyz).cross(c.xyz - a.xyz).dot(normal) / length;
}

double min_angle_tangent(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3 ab = b.xyz - a.xyz, bc = c.xyz - b.xyz, ca = a.xyz - c.xyz;
  // The smallest angle lies opposite the shortest side, between the two longer ones.
  const double ab2 = ab.squaredNorm(), bc2 = bc.squaredNorm(), ca2 = ca.squaredNorm();
  const Vec3 cross = ab.cross(bc);
  double dot = 0.0;
  if (ab2 <= bc2 && ab2 <= ca2) {
    dot = -bc.dot(ca);
  } else if (bc2 <= ca2) {
    dot = -ab.dot(ca);
  } else {
    dot = -ab.dot(bc);
  }
  const double tangent = dot > 0.0 ? cross.norm() / dot : 0.0;
  return cross.dot(a.normal + b.normal + c.normal) > 0.0 ? tangent : -tangent;
}

double min_angle(const Corner& a, const Corner& b, const Corner& c) {
  return std::atan(min_angle_tangent(a, b, c));
}

double deviation_cosine(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3 cross = (b.xyz - a.xyz).cross(c.xyz - a.xyz);
  const Vec3 normal = a.normal + b.normal + c.normal;
  const double scale = cross.norm() * normal.norm();
  return scale > 0.0 ? cross.dot(normal) / scale : 1.0;
}

double corner_cosine(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3 cross = (b.xyz - a.xyz).cross(c.xyz - a.xyz);
  const double scale = cross.norm();
  if (!(scale > 0.0)) return 1.0;
  return std::min({cross.dot(a.normal), cross.dot(b.normal), cross.dot(c.normal)}) / scale;
}

double inner_angle(const Corner& a, const Corner& b, const Corner& c) {
  return turn_angle(c.xyz - b.xyz, a.xyz - b.xyz, b.normal);
}

}  // namespace advlayers
