// The order of points along a Hilbert curve: neighbours in the order are near each other.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "base/types.h"

namespace advlayers {

// Throws Cancelled.
std::vector<int> hilbert_order(const RunContext& context, const std::vector<Vec2>& points);

}  // namespace advlayers
