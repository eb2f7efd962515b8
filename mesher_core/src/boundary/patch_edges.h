// Which CAD edges bound a patch, and which lie inside it.
#pragma once

#include <vector>

#include "geometry/evaluator.h"

namespace advlayers {

// The edges inside the patch, sorted: shared by exactly two of its faces that meet there at an
// angle below `feature_angle` [deg], or the seam of one face along which it is smooth. An edge that
// a face uses twice in one place (a slit), a crease, and an edge of three faces bound the patch.
std::vector<EdgeId> inner_edges(Evaluator& evaluator, const std::vector<FaceId>& patch,
                                double feature_angle);

}  // namespace advlayers
