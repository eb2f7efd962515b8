#include "triangulate/triangle_score.h"

#include <algorithm>
#include <cmath>

#include "base/ties.h"

namespace advlayers {
namespace {

constexpr double kSineOf60 = 0.86602540378443865;  // the score of an equilateral triangle is 1
// cos 27 degrees: the mean of the corners' normals stands for the normal at the centroid, hence
// the distance to the bound.
constexpr double kLeastCosine = 0.8910065241883679;
// cos 65 degrees: no corner's normal may lean further.
constexpr double kLeastCornerCosine = 0.42261826174069944;

}  // namespace

double triangle_score(const Corner& a, const Corner& b, const Corner& c) {
  const Vec3 ab = b.xyz - a.xyz, bc = c.xyz - b.xyz, ca = a.xyz - c.xyz;
  const Vec3 cross = ab.cross(bc);
  const double area2 = cross.norm();
  if (area2 <= 0.0) return -1.0;
  const Vec3 sum = a.normal + b.normal + c.normal;
  const double corner_cosine = std::min({a.normal.isZero() ? area2 : cross.dot(a.normal),
                                         b.normal.isZero() ? area2 : cross.dot(b.normal),
                                         c.normal.isZero() ? area2 : cross.dot(c.normal)}) /
                               area2;
  const double lean = std::min(cross.dot(sum) / (area2 * sum.norm()) - kLeastCosine,
                               corner_cosine - kLeastCornerCosine);
  if (lean < 0.0) return settled(lean);
  const double ab2 = ab.squaredNorm(), bc2 = bc.squaredNorm(), ca2 = ca.squaredNorm();
  const double two_longest = ab2 * bc2 * ca2 / std::min({ab2, bc2, ca2});
  return settled(area2 / (std::sqrt(two_longest) * kSineOf60));
}

double score_of_angle(double angle) { return std::sin(angle) / kSineOf60; }

}  // namespace advlayers
