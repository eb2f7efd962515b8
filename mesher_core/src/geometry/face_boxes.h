// Boxes about the faces of a model: which faces a point may lie on.
#pragma once

#include <vector>

#include "geometry/model.h"

namespace advlayers {

using Box = Eigen::AlignedBox3d;

// By face, each holding the whole trimmed face [mm]; empty for a face without a surface.
// Throws GeometryError.
std::vector<Box> face_boxes(const Model& model);

}  // namespace advlayers
