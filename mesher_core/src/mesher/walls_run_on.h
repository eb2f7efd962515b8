// Walls that end where their neighbour goes straight on or turns away: the start of a flat plate, a
// step. Nothing stands there for the layers to end at, so they run on along the neighbour.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/evaluator.h"
#include "layers/wall_plan.h"
#include "sizing/settings.h"

namespace advlayers {

// Of the edges that the settings name neither as walls nor as match or off edges. What a wall that
// runs on meets at its other end runs along the layers if it stands square enough; the layers go no
// farther. Throws GeometryError and Cancelled.
void run_walls_on(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                  const std::vector<FaceId>& faces, WallPlan& walls);

}  // namespace advlayers
