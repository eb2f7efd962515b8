// The solids of a model, as the faces around each.
#pragma once

#include <vector>

#include "geometry/model.h"

namespace advlayers {

// In the order in which the shape holds them; faces ascending, those of cavities too. A face
// between two solids is in both. Empty for a shape without solids.
std::vector<std::vector<FaceId>> solids_of(const Model& model);

}  // namespace advlayers
