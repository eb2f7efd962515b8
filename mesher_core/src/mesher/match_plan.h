// Where the layers of one patch run along a match edge.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "boundary/match_end.h"
#include "geometry/evaluator.h"
#include "layers/wall_plan.h"

namespace advlayers {

struct MatchPlan {
  std::vector<MatchEnd> ends;
  std::vector<Diagnostic> notes;  // of match edges that meet their wall at too slant an angle
};

// The ends of the patch's match edges that a wall meets at 45 to 135 degrees, inside the patch.
// Throws GeometryError and Cancelled.
MatchPlan plan_matches(const RunContext& context, Evaluator& evaluator,
                       const std::vector<FaceId>& faces, const WallPlan& walls);

}  // namespace advlayers
