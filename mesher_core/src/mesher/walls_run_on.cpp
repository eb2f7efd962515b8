#include "mesher/walls_run_on.h"

#include <unordered_map>
#include <unordered_set>

#include "layers/corner_class.h"
#include "mesher/patch_corners.h"

namespace advlayers {
namespace {

class RunOn {
 public:
  RunOn(const Settings& settings, WallPlan& walls) : walls_(walls) {
    for (const auto* list : {&settings.match_edges, &settings.off_edges}) {
      named_.insert(list->begin(), list->end());
    }
  }

  void run(const std::vector<FaceCorner>& corners) {
    for (const FaceCorner& corner : corners) {
      go_on(corner.in.edge, corner.out.edge, corner.angle);
      go_on(corner.out.edge, corner.in.edge, corner.angle);
    }
    for (const EdgeId edge : new_walls_) walls_.edges.at(edge) = plans_.at(edge);
    for (const FaceCorner& corner : corners) {
      match(corner.in.edge, corner.out.edge, corner.angle);
      match(corner.out.edge, corner.in.edge, corner.angle);
    }
  }

 private:
  // By the walls that were asked for, all at once: the order of corners does not matter.
  void go_on(EdgeId wall, EdgeId neighbour, double angle) {
    const EdgePlan& plan = walls_.edges.at(wall);
    if (plan.condition != EdgeCondition::kWall || !is_free(neighbour)) return;
    if (angle <= (kLargestAlong + kChordSlack) * kDegree) return;
    const auto made = plans_.emplace(neighbour, plan);
    if (!made.second) return;
    EdgePlan& next = made.first->second;
    next.rule = HeightRule();
    new_walls_.push_back(neighbour);
  }
  void match(EdgeId wall, EdgeId neighbour, double angle) {
    if (plans_.count(wall) == 0 || !is_free(neighbour) || !layers_run_along(angle)) return;
    walls_.edges.at(neighbour).condition = EdgeCondition::kMatch;
  }
  bool is_free(EdgeId edge) const {
    return walls_.edges.at(edge).condition != EdgeCondition::kWall && named_.count(edge) == 0;
  }

  WallPlan& walls_;
  std::unordered_set<EdgeId> named_;
  std::unordered_map<EdgeId, EdgePlan> plans_;
  std::vector<EdgeId> new_walls_;
};

bool has_both(const WallPlan& walls) {
  bool wall = false, other = false;
  for (const auto& [edge, plan] : walls.edges) {
    (plan.condition == EdgeCondition::kWall ? wall : other) = true;
  }
  return wall && other;
}

}  // namespace

void run_walls_on(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                  const std::vector<FaceId>& faces, WallPlan& walls) {
  if (!has_both(walls)) return;
  RunOn(settings, walls).run(patch_corners(context, evaluator, faces, walls));
}

}  // namespace advlayers
