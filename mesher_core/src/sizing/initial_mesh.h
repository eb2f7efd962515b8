// An existing triangulation of the shape, as the caller has it.
#pragma once

#include <array>
#include <vector>

#include "base/types.h"

namespace advlayers {

struct InitialMesh {
  std::vector<Vec3> points;                   // [mm], where the shape stands
  std::vector<std::array<int, 3>> triangles;  // into points; either way round
};

}  // namespace advlayers
