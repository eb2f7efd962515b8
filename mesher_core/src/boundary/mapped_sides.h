// Sides of mapped faces: as many segments on those that face each other.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/stretch.h"
#include "geometry/four_sides.h"

namespace advlayers {

// The longest segments of the side that has fewer are parted, until sides agree over all faces.
// After all else: the segments shorten no other edge's.
void even_out_sides(const RunContext& context, const std::vector<FourSides>& mapped,
                    Stretches& stretches);

}  // namespace advlayers
