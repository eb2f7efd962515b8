// How a column of layers grows on: the same in the plan of an edge, at a front node and in a kid.
#pragma once

#include <algorithm>

#include "sizing/wall_spacing.h"

namespace advlayers {

struct Growth {
  double height = 0.0;             // of the next layer [mm]
  double ratio = 1.0;              // of each layer's height to the one before
  int layers_left = kUntilClosed;  // 0: complete

  // Once the next layer is there.
  Growth next() const { return {height * ratio, ratio, layers_left - 1}; }
  // Of one column where two meet: the mean heights, the fewer layers.
  Growth met_by(const Growth& o) const {
    return {0.5 * (height + o.height), 0.5 * (ratio + o.ratio),
            std::min(layers_left, o.layers_left)};
  }
};

}  // namespace advlayers
