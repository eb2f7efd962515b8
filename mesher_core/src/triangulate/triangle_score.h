// One number for how good a triangle of the triangulation is, so that every local operation asks
// the same question: does the worst triangle it touches get better?
#pragma once

#include "mesh/triangle_measures.h"

namespace advlayers {

// Within the deviation bound: the sine of the smallest angle over that of 60 degrees, 0 … 1. Beyond
// it: negative, the more the further the triangle leans. A corner with a zero normal (a sharp
// tip) has no say in the deviation.
double triangle_score(const Corner& a, const Corner& b, const Corner& c);

// The score of a triangle within the bound whose smallest angle is so large [rad].
double score_of_angle(double angle);

// A triangle's normal may lean so far [rad] from the surface's at its centroid (paper, III).
inline constexpr double kDeviationBound = 0.5235987755982988;

}  // namespace advlayers
