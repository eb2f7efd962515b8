#include "boundary/patch_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace advlayers {
namespace {

constexpr double kDegree = M_PI / 180;
// A seam is a line of the parametrization, no feature, even where every face is a patch of its own.
constexpr double kSmoothSeam = 1.0 * kDegree;
constexpr std::array<double, 5> kSamples{0.03, 0.25, 0.5, 0.75, 0.97};
// Two uses of an edge in the same place of (u, v), relative to the face's extent.
constexpr double kSamePlace = 1e-6;

struct Use {
  FaceId face;
  const CoEdge* coedge;
};

bool is_slit(Evaluator& evaluator, EdgeId id, const Use& a, const Use& b) {
  const Edge& edge = evaluator.model().edge(id);
  const Face& face = evaluator.model().face(a.face);
  const double t = (edge.first + edge.last) / 2;
  const Vec2 apart =
      evaluator.edge_uv(a.face, *a.coedge, t) - evaluator.edge_uv(b.face, *b.coedge, t);
  return std::abs(apart.x()) < kSamePlace * (face.u_max - face.u_min) &&
         std::abs(apart.y()) < kSamePlace * (face.v_max - face.v_min);
}

// The largest angle [rad] between the normals on the two sides.
double crease_angle(Evaluator& evaluator, EdgeId id, const Use& a, const Use& b) {
  const Edge& edge = evaluator.model().edge(id);
  double largest = 0;
  for (const double s : kSamples) {
    const double t = edge.first + s * (edge.last - edge.first);
    const Vec2 uv_a = evaluator.edge_uv(a.face, *a.coedge, t);
    const Vec2 uv_b = evaluator.edge_uv(b.face, *b.coedge, t);
    const Vec3 normal_a = evaluator.frame(a.face, uv_a.x(), uv_a.y()).normal;
    const Vec3 normal_b = evaluator.frame(b.face, uv_b.x(), uv_b.y()).normal;
    largest =
        std::max(largest, std::atan2(normal_a.cross(normal_b).norm(), normal_a.dot(normal_b)));
  }
  return largest;
}

bool is_inner(Evaluator& evaluator, EdgeId id, const std::vector<Use>& uses, double feature_angle) {
  if (uses.size() != 2 || uses[0].coedge->degenerate) return false;
  const bool one_face = uses[0].face == uses[1].face;
  const std::size_t faces = evaluator.model().edge(id).faces.size();
  if (faces > (one_face ? 1u : 2u)) return false;
  if (one_face) {
    if (is_slit(evaluator, id, uses[0], uses[1])) return false;
    return crease_angle(evaluator, id, uses[0], uses[1]) <
           std::max(kSmoothSeam, feature_angle * kDegree);
  }
  return crease_angle(evaluator, id, uses[0], uses[1]) < feature_angle * kDegree;
}

}  // namespace

std::vector<EdgeId> inner_edges(Evaluator& evaluator, const std::vector<FaceId>& patch,
                                double feature_angle) {
  std::map<EdgeId, std::vector<Use>> uses;
  for (const FaceId f : patch) {
    for (const auto& loop : evaluator.model().face(f).loops) {
      for (const CoEdge& coedge : loop) uses[coedge.edge].push_back({f, &coedge});
    }
  }
  std::vector<EdgeId> inner;
  for (const auto& [edge, edge_uses] : uses) {
    if (is_inner(evaluator, edge, edge_uses, feature_angle)) inner.push_back(edge);
  }
  return inner;
}

}  // namespace advlayers
