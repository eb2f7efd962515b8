// What grows from each boundary edge of one patch, resolved from the settings.
#pragma once

#include <limits>
#include <vector>

#include "base/types.h"

namespace advlayers {

enum class EdgeCondition : std::uint8_t { kOff, kWall, kMatch };

struct EdgePlan {
  EdgeCondition condition = EdgeCondition::kOff;
  double first_height = 0.0;  // [mm]
  double growth = 1.0;
  int layers = std::numeric_limits<int>::max();
};

struct WallPlan {
  std::vector<EdgePlan> edges;  // by EdgeId over the whole model
  bool stop_at_isotropy = false;
};

}  // namespace advlayers
