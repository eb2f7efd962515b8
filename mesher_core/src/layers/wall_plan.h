// What grows from each boundary edge of one patch, resolved from the settings.
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "base/types.h"
#include "sizing/wall_spacing.h"

namespace advlayers {

enum class EdgeCondition : std::uint8_t { kOff, kWall, kMatch };

struct EdgePlan {
  EdgeCondition condition = EdgeCondition::kOff;
  double first_height = 0.0;  // [mm]
  double growth = 1.0;
  int layers = kUntilClosed;
  HeightRule rule{};
  // Where the rule makes the first height vary: that at each node of the edge [mm].
  std::unordered_map<NodeId, double> heights{};
  std::vector<double> heights_along{};  // the same, in the order of the edge's nodes

  double height_at(NodeId node) const {
    const auto found = heights.find(node);
    return found == heights.end() ? first_height : found->second;
  }
};

struct WallPlan {
  // The patch's boundary edges alone: with one entry per edge of the model in every patch, a model
  // of thousands of faces would cost gigabytes.
  std::unordered_map<EdgeId, EdgePlan> edges;
  bool stop_at_isotropy = false;
  double max_height = std::numeric_limits<double>::infinity();  // no layer is higher [mm]
};

}  // namespace advlayers
