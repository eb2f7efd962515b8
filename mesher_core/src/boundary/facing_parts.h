// Parts of a face's boundary that face each other across a gap no wider than some segments: two
// holes near to each other, the loops of a ring, the sides of a fin or a tip.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/evaluator.h"
#include "sizing/size_field.h"

namespace advlayers {

struct FacingPart {
  EdgeId edge;
  double t_begin = 0.0, t_end = 0.0;
};

struct FacingParts {
  FacingPart a, b;
  bool reversed = false;  // along b the edge's parameter runs against that along a
};

// Where the nodes of a part may be placed to face those of another: not on edges that the user
// has cut, nor on those that layers run along.
class FacingEdges {
 public:
  FacingEdges(const RunContext& context, Evaluator& evaluator, const SizeField& sizes,
              double curvature_angle, std::vector<char> given)
      : context_(context),
        evaluator_(evaluator),
        sizes_(sizes),
        curvature_angle_(curvature_angle),
        given_(std::move(given)) {}

  // The parts of one face's boundary. Their ends are added to `joints`, by EdgeId the parameters at
  // which an edge has a node.
  void find(FaceId face, std::vector<std::vector<double>>& joints);
  // Joints that were added after a part was found are given their like on the other side.
  void face_joints(std::vector<std::vector<double>>& joints);
  std::vector<FacingParts> release() { return std::move(found_); }

 private:
  bool face_joints_of(const FacingParts& parts, std::vector<std::vector<double>>& joints);

  const RunContext& context_;
  Evaluator& evaluator_;
  const SizeField& sizes_;
  double curvature_angle_;   // [rad]
  std::vector<char> given_;  // by EdgeId
  std::vector<FacingParts> found_;
};

}  // namespace advlayers
