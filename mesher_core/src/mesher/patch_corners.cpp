#include "mesher/patch_corners.h"

namespace advlayers {
namespace {

// From a boundary edge about its vertex, over the edges inside the patch, to the next one. Returns
// false where it leads to none.
bool follow(FaceCorner& corner, const std::vector<FaceCorner>& corners, const WallPlan& walls) {
  const auto bounds = [&](EdgeId edge) { return walls.edges.count(edge) > 0; };
  if (!bounds(corner.in.edge)) return false;
  for (std::size_t k = 0; k < corners.size() && !bounds(corner.out.edge); ++k) {
    const FaceCorner* beyond = nullptr;
    for (const FaceCorner& c : corners) {
      if (c.in.edge == corner.out.edge && c.in.end == corner.out.end) beyond = &c;
    }
    if (beyond == nullptr) return false;
    corner.out = beyond->out;
    corner.angle += beyond->angle;
  }
  return bounds(corner.out.edge);
}

}  // namespace

std::vector<FaceCorner> patch_corners(const RunContext& context, Evaluator& evaluator,
                                      const std::vector<FaceId>& faces, const WallPlan& walls) {
  std::vector<FaceCorner> corners, found;
  for (const FaceId face : faces) {
    context.check();
    const std::vector<FaceCorner> own = corners_of(evaluator, face);
    corners.insert(corners.end(), own.begin(), own.end());
  }
  for (FaceCorner corner : corners) {
    context.check();
    if (follow(corner, corners, walls)) found.push_back(corner);
  }
  return found;
}

}  // namespace advlayers
