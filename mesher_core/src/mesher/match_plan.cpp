#include "mesher/match_plan.h"

#include <cmath>

#include "base/angles.h"
#include "layers/corner_class.h"
#include "mesher/patch_corners.h"

namespace advlayers {
namespace {

class MatchPlanner {
 public:
  MatchPlanner(const RunContext& context, Evaluator& evaluator, const WallPlan& walls)
      : context_(context), evaluator_(evaluator), walls_(walls) {}

  MatchPlan run(const std::vector<FaceId>& faces) {
    if (has(EdgeCondition::kMatch) && has(EdgeCondition::kWall)) {
      for (const FaceCorner& corner : patch_corners(context_, evaluator_, faces, walls_)) {
        add(corner);
      }
    }
    return std::move(plan_);
  }

 private:
  bool has(EdgeCondition condition) const {
    for (const auto& [edge, plan] : walls_.edges) {
      if (plan.condition == condition) return true;
    }
    return false;
  }
  void add(const FaceCorner& corner) {
    const EdgePlan &in = walls_.edges.at(corner.in.edge), &out = walls_.edges.at(corner.out.edge);
    if (in.condition == EdgeCondition::kWall) add(corner, corner.in, in, corner.out, out);
    if (out.condition == EdgeCondition::kWall) add(corner, corner.out, out, corner.in, in);
  }

  void add(const FaceCorner& corner, CornerSide wall, const EdgePlan& plan, CornerSide along,
           const EdgePlan& other) {
    if (other.condition != EdgeCondition::kMatch) return;
    if (!layers_run_along(corner.angle)) {
      note(corner, wall.edge, along.edge);
      return;
    }
    MatchEnd end;
    end.edge = along.edge;
    end.end = along.end;
    end.wall = wall.edge;
    end.wall_end = wall.end;
    end.face = corner.face;
    end.spacing = {plan.growth.height, plan.growth.ratio, plan.growth.layers_left, plan.rule};
    end.sine = std::sin(corner.angle);
    end.stop_at_isotropy = walls_.stop_at_isotropy;
    end.max_height = walls_.max_height;
    plan_.ends.push_back(end);
  }

  void note(const FaceCorner& corner, EdgeId wall, EdgeId along) {
    Diagnostic note;
    note.severity = Severity::kInfo;
    note.code = "match-angle";
    note.sentence = Sentence(
        "{} meets the wall {} at {} degrees on {}: layers end there instead of running along it",
        edge_name(along), edge_name(wall), std::lround(corner.angle / kDegree),
        face_name(corner.face));
    plan_.notes.push_back(std::move(note));
  }

  const RunContext& context_;
  Evaluator& evaluator_;
  const WallPlan& walls_;
  MatchPlan plan_;
};

}  // namespace

MatchPlan plan_matches(const RunContext& context, Evaluator& evaluator,
                       const std::vector<FaceId>& faces, const WallPlan& walls) {
  return MatchPlanner(context, evaluator, walls).run(faces);
}

}  // namespace advlayers
