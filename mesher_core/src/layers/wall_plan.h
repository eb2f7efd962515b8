// What grows from each boundary edge of one patch, resolved from the settings.
#pragma once

#include <limits>
#include <unordered_map>
#include <vector>

#include "base/types.h"
#include "layers/growth.h"
#include "sizing/wall_spacing.h"

namespace advlayers {

enum class EdgeCondition : std::uint8_t { kOff, kWall, kMatch };

struct EdgePlan {
  EdgeCondition condition = EdgeCondition::kOff;
  Growth growth{};
  HeightRule rule{};
  // Where the rule makes the first height vary: that at each node of the edge [mm].
  std::unordered_map<NodeId, double> heights{};
  std::vector<double> heights_along{};  // the same, in the order of the edge's nodes

  double height_at(NodeId node) const {
    const auto found = heights.find(node);
    return found == heights.end() ? growth.height : found->second;
  }
  Growth growth_at(NodeId node) const {
    return {height_at(node), growth.ratio, growth.layers_left};
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
