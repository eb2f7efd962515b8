// Where a curve begins by running away from its edge: intersection curves of faces that touch do so
// beside their vertices, and come back within the edge's tolerance.
#pragma once

#include "geometry/evaluator.h"

namespace advlayers {

// The parameters at which the curve leaves the ends of its edge for good: those of the edge itself,
// but where the curve first runs out and back over less than a tenth of the edge's length.
struct EdgeExtent {
  double first, last;
};
EdgeExtent extent_without_overshoot(Evaluator& evaluator, EdgeId edge);

}  // namespace advlayers
