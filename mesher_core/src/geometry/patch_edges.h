// Which CAD edges bound a patch, and which lie inside it.
#pragma once

#include <string>
#include <vector>

#include "geometry/evaluator.h"

namespace advlayers {

// What parts patches: the angle at which faces meet, but for the edges that were decided by hand.
struct FeatureRule {
  FeatureRule(double angle) : feature_angle(angle) {}  // most rules are no more than an angle

  double feature_angle;            // [deg]
  std::vector<EdgeId> boundary{};  // sorted; these bound patches whatever their angle
  std::vector<EdgeId> smooth{};    // sorted; patches continue over these whatever their angle
};

// The edges inside the patch, sorted: shared by exactly two of its faces that meet there at an
// angle below the rule's, or the seam of one face along which it is smooth. An edge that a face
// uses twice in one place (a slit), a crease, and an edge of three faces bound the patch.
std::vector<EdgeId> inner_edges(Evaluator& evaluator, const std::vector<FaceId>& patch,
                                const FeatureRule& rule);

// Why a patch cannot continue over the edge, whatever the rule: "it bounds one face only"; empty
// where it can.
Sentence reason_to_bound(Evaluator& evaluator, EdgeId edge);

}  // namespace advlayers
