// The directions of a smooth field over the core that is aligned with its border: crosses where
// quads are to be, stars of six arms where triangles are.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "core/core_room.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

struct CrossDirection {
  Vec3 along = Vec3::Zero();
  double weight = 0.0;
  bool given = false;  // by the border
};

// By vertex of the room, in its order; 4 or 6 arms. Throws Cancelled.
std::vector<CrossDirection> find_cross_directions(const RunContext& context,
                                                  const SurfaceMesh& mesh, const CoreRoom& room,
                                                  int arms);

}  // namespace advlayers
