// Which faces are meshed together, and what grows from each of their boundary edges: the
// settings, resolved against the model.
#pragma once

#include <string>
#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/evaluator.h"
#include "layers/wall_plan.h"
#include "sizing/settings.h"

namespace advlayers {

// The faces of each patch, in rising order; patches by their first face. Faces that meet smoothly
// are one patch; every face asked for is in exactly one, and one with a defect is alone.
std::vector<std::vector<FaceId>> group_faces(const RunContext& context, const Model& model,
                                             const Settings& settings);

// What grows from each edge that bounds the patch. Throws GeometryError and Cancelled.
WallPlan plan_walls(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                    const std::vector<FaceId>& faces);

// Works first heights out at the boundary's nodes, where a rule makes them vary. Throws Cancelled.
void resolve_heights(const RunContext& context, Evaluator& evaluator,
                     const Discretization& boundary, WallPlan& walls);

// The face of the patch that an edge of its boundary belongs to, the first of several.
FaceId face_beside(const Model& model, const std::vector<FaceId>& faces, EdgeId edge);

// "Face3", or "Face3 and 4 more" for a patch of several.
std::string patch_name(const std::vector<FaceId>& faces);

}  // namespace advlayers
