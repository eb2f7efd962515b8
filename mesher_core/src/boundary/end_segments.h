// An edge cut with given lengths at its ends.
#pragma once

#include <optional>
#include <vector>

#include "sizing/settings.h"

namespace advlayers {

struct EndSegments {
  std::optional<double> first, last;  // [mm]
  Distribution distribution = Distribution::kTanh;
  int segments = 0;  // 0: the fewest of which none is longer than the size
};

// Ends of segments along `length` [mm], from 0 to it: the first and the last as long as given, but
// no longer than even ones. kTanh follows Vinokur's hyperbolic tangents (J. Comput. Phys. 50,
// 1983), which change least from step to step; kGeometric has steps of one ratio from an end, of
// two that meet in the middle from both; kConstant has segments alike between the two ends.
std::vector<double> cut_with_ends(double length, double size, const EndSegments& ends);

}  // namespace advlayers
