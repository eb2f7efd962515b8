#include "geometry/patch_edges.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angles.h"

namespace advlayers {
namespace {

// A seam is a line of the parametrization, no feature, even where every face is a patch of its own.
constexpr double kSmoothSeam = 1.0 * kDegree;
// Two uses of an edge in the same place of (u, v), relative to the face's extent.
constexpr double kSamePlace = 1e-6;

struct Use {
  FaceId face;
  const CoEdge* coedge;
};

using EdgeUses = std::map<EdgeId, std::vector<Use>>;

EdgeUses uses_of(const Model& model, const std::vector<FaceId>& faces) {
  EdgeUses uses;
  for (const FaceId f : faces) {
    for (const auto& loop : model.face(f).loops) {
      for (const CoEdge& coedge : loop) uses[coedge.edge].push_back({f, &coedge});
    }
  }
  return uses;
}

bool is_slit(Evaluator& evaluator, EdgeId id, const std::vector<Use>& uses) {
  if (uses[0].face != uses[1].face) return false;
  const Edge& edge = evaluator.model().edge(id);
  const Face& face = evaluator.model().face(uses[0].face);
  const double t = (edge.first + edge.last) / 2;
  const Vec2 apart = evaluator.edge_uv(uses[0].face, *uses[0].coedge, t) -
                     evaluator.edge_uv(uses[1].face, *uses[1].coedge, t);
  return std::abs(apart.x()) < kSamePlace * (face.u_max - face.u_min) &&
         std::abs(apart.y()) < kSamePlace * (face.v_max - face.v_min);
}

// Whether exactly two sides of faces meet at the edge, so that a patch may continue over it.
bool has_two_sides(Evaluator& evaluator, EdgeId id, const std::vector<Use>& uses) {
  if (uses.size() != 2 || uses[0].coedge->degenerate) return false;
  const bool one_face = uses[0].face == uses[1].face;
  if (evaluator.model().edge(id).faces.size() > (one_face ? 1u : 2u)) return false;
  return !is_slit(evaluator, id, uses);
}

bool is_inner(Evaluator& evaluator, EdgeId id, const std::vector<Use>& uses,
              const FeatureRule& rule) {
  const auto listed = [id](const std::vector<EdgeId>& edges) {
    return std::binary_search(edges.begin(), edges.end(), id);
  };
  if (!has_two_sides(evaluator, id, uses) || listed(rule.boundary)) return false;
  if (listed(rule.smooth)) return true;
  const bool seam = uses[0].face == uses[1].face;
  const double most = rule.feature_angle * kDegree;
  return evaluator.model().dihedral_angle(id) < (seam ? std::max(kSmoothSeam, most) : most);
}

}  // namespace

std::vector<EdgeId> inner_edges(Evaluator& evaluator, const std::vector<FaceId>& patch,
                                const FeatureRule& rule) {
  std::vector<EdgeId> inner;
  for (const auto& [edge, uses] : uses_of(evaluator.model(), patch)) {
    if (is_inner(evaluator, edge, uses, rule)) inner.push_back(edge);
  }
  return inner;
}

Sentence reason_to_bound(Evaluator& evaluator, EdgeId edge) {
  const Model& model = evaluator.model();
  const std::vector<FaceId>& faces = model.edge(edge).faces;
  if (model.edge(edge).degenerate) return Sentence("it is a pole without length");
  if (faces.empty()) return Sentence("it bounds no face");
  if (faces.size() > 2) return Sentence("{} faces meet there", faces.size());
  const EdgeUses uses = uses_of(model, faces);
  const std::vector<Use>& own = uses.at(edge);
  if (own.size() == 1) return Sentence("it bounds {} alone", face_name(faces[0]));
  if (has_two_sides(evaluator, edge, own)) return {};
  return own.size() > 2 ? Sentence("its faces use it more than twice")
                        : Sentence("{} has a slit there", face_name(faces[0]));
}

}  // namespace advlayers
