// One number for how good a triangle of the triangulation is, so that every local operation asks
// the same question: do the triangles it touches get better?
#pragma once

#include <algorithm>
#include <limits>

#include "mesh/triangle_measures.h"

namespace advlayers {

// Within the deviation bound: the sine of the smallest angle over that of 60 degrees, 0 … 1. Beyond
// it: negative, the more the further the triangle leans. A corner with a zero normal (a sharp
// tip) has no say in the deviation.
double triangle_score(const Corner& a, const Corner& b, const Corner& c);

// The score of a triangle within the bound whose smallest angle is so large [rad].
double score_of_angle(double angle);

// How good several triangles are together: the worst score, or, where some are negative, their sum,
// so that each of them counts.
class Standing {
 public:
  void add(double score) {
    worst_ = std::min(worst_, score);
    debt_ += std::min(0.0, score);
  }
  double value() const { return debt_ < 0.0 ? debt_ : worst_; }

 private:
  double worst_ = std::numeric_limits<double>::infinity();
  double debt_ = 0.0;
};

// A triangle's normal may lean so far [rad] from the surface's at its centroid (paper, III).
inline constexpr double kDeviationBound = 0.5235987755982988;

}  // namespace advlayers
