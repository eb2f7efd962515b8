#include "geometry/face_corners.h"

#include "base/directions.h"

namespace advlayers {
namespace {

constexpr double kChordPart = 1e-3;  // of the edge's range, where its tangent vanishes

// Unit direction in which the edge leaves one of its ends.
Vec3 direction_from(Evaluator& evaluator, CornerSide side) {
  const Edge& edge = evaluator.model().edge(side.edge);
  const double t = side.end == 0 ? edge.first : edge.last;
  const double sign = side.end == 0 ? 1.0 : -1.0;
  const Vec3 tangent = sign * evaluator.edge_tangent(side.edge, t);
  if (tangent.norm() * (edge.last - edge.first) > 1e-6 * edge.length) return tangent.normalized();
  const double beside = t + sign * kChordPart * (edge.last - edge.first);
  return (evaluator.edge_point(side.edge, beside) - evaluator.edge_point(side.edge, t))
      .normalized();
}

}  // namespace

FaceCorner corner_between(Evaluator& evaluator, FaceId face, const CoEdge& in, const CoEdge& out) {
  FaceCorner corner{face, {in.edge, in.forward ? 1 : 0}, {out.edge, out.forward ? 0 : 1}};
  const Edge& edge = evaluator.model().edge(out.edge);
  const Vec2 uv = evaluator.edge_uv(face, out, out.forward ? edge.first : edge.last);
  const Vec3 normal = evaluator.frame(face, uv.x(), uv.y()).normal;
  corner.angle = turn_angle(direction_from(evaluator, corner.out),
                            direction_from(evaluator, corner.in), normal);
  return corner;
}

std::vector<FaceCorner> corners_of(Evaluator& evaluator, FaceId face) {
  std::vector<FaceCorner> corners;
  for (const auto& loop : evaluator.model().face(face).loops) {
    std::vector<const CoEdge*> run;
    for (const CoEdge& coedge : loop) {
      if (!coedge.degenerate) run.push_back(&coedge);
    }
    for (std::size_t k = 0; k < run.size(); ++k) {
      corners.push_back(corner_between(evaluator, face, *run[k], *run[(k + 1) % run.size()]));
    }
  }
  return corners;
}

}  // namespace advlayers
