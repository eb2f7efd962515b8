// Where the boundary of a patch turns from one of its edges into the next, over the edges inside.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/face_corners.h"
#include "layers/wall_plan.h"

namespace advlayers {

// Corners between two edges of the plan; the angle is that of all faces of the patch between them.
// Throws GeometryError and Cancelled.
std::vector<FaceCorner> patch_corners(const RunContext& context, Evaluator& evaluator,
                                      const std::vector<FaceId>& faces, const WallPlan& walls);

}  // namespace advlayers
