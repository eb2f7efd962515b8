// Faces that layers cannot run across, however smoothly they meet their neighbours.
#pragma once

#include <vector>

#include "geometry/evaluator.h"
#include "sizing/settings.h"

namespace advlayers {

// Faces far narrower than the size that turn about a good part of a right angle all the same, as
// fillets of edges do: for elements of that size they are edges. Sorted.
std::vector<FaceId> tight_faces(Evaluator& evaluator, const Settings& settings);

}  // namespace advlayers
