// Faces that layers cannot run across, however smoothly they meet their neighbours.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/evaluator.h"
#include "sizing/settings.h"

namespace advlayers {

// Faces far narrower than the size that turn about a good part of a right angle all the same, as
// fillets of edges do: for elements of that size they are edges. Sorted.
// Throws Cancelled.
std::vector<FaceId> tight_faces(const RunContext& context, Evaluator& evaluator,
                                const Settings& settings);

}  // namespace advlayers
