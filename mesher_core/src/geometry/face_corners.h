// Where the boundary of a face turns from one edge into the next.
#pragma once

#include <vector>

#include "geometry/evaluator.h"

namespace advlayers {

// An edge as a face's boundary runs into a vertex or out of it.
struct CornerSide {
  EdgeId edge;
  int end = 0;  // 0: the vertex is at the edge's first parameter
};

struct FaceCorner {
  FaceId face;
  CornerSide in, out;
  double angle = 0.0;  // inside the face [rad]
};

// The corner between two co-edges of the face, none of them degenerate, of which one follows the
// other.
FaceCorner corner_between(Evaluator& evaluator, FaceId face, const CoEdge& in, const CoEdge& out);

// All corners of the face's loops; degenerate edges are passed over.
std::vector<FaceCorner> corners_of(Evaluator& evaluator, FaceId face);

}  // namespace advlayers
