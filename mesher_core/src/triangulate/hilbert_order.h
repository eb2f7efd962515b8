// The order of points along a Hilbert curve: neighbours in the order are near each other.
#pragma once

#include <vector>

#include "base/types.h"

namespace advlayers {

std::vector<int> hilbert_order(const std::vector<Vec2>& points);

}  // namespace advlayers
