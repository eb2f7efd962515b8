#include "geometry/four_sides.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "geometry/face_corners.h"

namespace advlayers {
namespace {

// A corner turns into the face by so much; what turns less belongs to a side.
constexpr double kSharpest = 25.0 * kDegree;
constexpr double kBluntest = 150.0 * kDegree;

bool is_corner(double angle) { return angle > kSharpest && angle < kBluntest; }

}  // namespace

std::optional<FourSides> find_four_sides(Evaluator& evaluator, FaceId face) {
  const Model& model = evaluator.model();
  const auto& loops = model.face(face).loops;
  if (loops.size() != 1 || loops.front().size() < 4) return std::nullopt;
  const std::vector<CoEdge>& loop = loops.front();
  for (const CoEdge& coedge : loop) {
    if (coedge.degenerate) return std::nullopt;
  }
  std::vector<std::size_t> begins;  // of sides, in the loop
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const CoEdge& before = loop[(k + loop.size() - 1) % loop.size()];
    if (is_corner(corner_between(evaluator, face, before, loop[k]).angle)) begins.push_back(k);
  }
  if (begins.size() != 4) return std::nullopt;
  FourSides found;
  found.face = face;
  found.lengths.fill(0.0);
  for (std::size_t side = 0; side < 4; ++side) {
    const std::size_t end = begins[(side + 1) % 4];
    for (std::size_t k = begins[side]; k != end; k = (k + 1) % loop.size()) {
      found.sides[side].push_back(loop[k]);
      found.lengths[side] += model.edge(loop[k].edge).length;
    }
  }
  if (found.lengths[1] + found.lengths[3] > found.lengths[0] + found.lengths[2]) {
    std::rotate(found.sides.begin(), found.sides.begin() + 1, found.sides.end());
    std::rotate(found.lengths.begin(), found.lengths.begin() + 1, found.lengths.end());
  }
  return found;
}

}  // namespace advlayers
