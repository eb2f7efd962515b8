// A length divided by a spacing that varies along it.
#pragma once

#include <vector>

#include "base/types.h"

namespace advlayers {

inline constexpr double kEvenSpread = 1e-9;   // relative spread of an even spacing
inline constexpr double kMostSegments = 5e6;  // of one edge: beyond, the size is refused

struct SpacingSample {
  double s;        // from the begin
  double spacing;  // wanted there, in the unit of s; linear between samples
};

// The ends of segments that each hold an equal share of the integral of ds / spacing, from the
// first sample to the last, both included: the fewest that stay within it, and at least `least`.
// Throws InvalidInput where they were millions on that edge.
std::vector<double> divide_by_spacing(const std::vector<SpacingSample>& samples, int least,
                                      EdgeId edge);

}  // namespace advlayers
