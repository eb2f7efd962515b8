// How long the core's edges are to be at each vertex of its triangulation.
#pragma once

#include <array>
#include <vector>

#include "core/core_room.h"
#include "core/cross_directions.h"
#include "triangulate/target_size.h"

namespace advlayers {

// The lengths [mm] along a cross's `along` and across it.
using CrossSizes = std::array<double, 2>;

// By vertex of the room, in its order: those of the border's edges, and from there to the size
// asked for, no faster than it may change. Where the border is cut a little longer or shorter than
// that, so are rows and columns that begin there, as far as the other borders let them: they meet
// others whole then.
std::vector<CrossSizes> find_core_sizes(const SurfaceMesh& mesh, const CoreRoom& room,
                                        const std::vector<CrossDirection>& crosses, int arms,
                                        TargetSize& target);

}  // namespace advlayers
