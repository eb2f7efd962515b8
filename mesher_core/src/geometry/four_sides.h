// Faces that are bounded by four sides, as a strip of the surface is.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geometry/evaluator.h"

namespace advlayers {

// The boundary of a face as four runs of co-edges between its corners, in the order of its loop.
// Sides 0 and 2 face each other and are together at least as long as 1 and 3. A closed band has its
// two rims for the long sides and its seam for both short ones, or the other way round.
struct FourSides {
  FaceId face;
  std::array<std::vector<CoEdge>, 4> sides;
  std::array<double, 4> lengths;  // [mm]

  // From side 0 to side 2, on the whole [mm].
  double width(const Model& model) const {
    return 2.0 * model.face(face).area / (lengths[0] + lengths[2]);
  }
};

// None where the boundary is not one loop, or turns sharply at fewer or more than four places.
std::optional<FourSides> find_four_sides(Evaluator& evaluator, FaceId face);

}  // namespace advlayers
