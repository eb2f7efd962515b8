#include "mesher/patch_plan.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

#include "boundary/patch_edges.h"

namespace advlayers {
namespace {

using EdgeSet = std::unordered_set<EdgeId>;

constexpr int kUntilClosed = std::numeric_limits<int>::max();

// Every edge that bounds the patch: of all faces, but degenerate and inner ones.
EdgeSet boundary_edges(Evaluator& evaluator, const Settings& settings,
                       const std::vector<FaceId>& faces) {
  const auto inner = inner_edges(evaluator, faces, settings.feature_angle);
  EdgeSet edges;
  for (const FaceId face : faces) {
    for (const auto& loop : evaluator.model().face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const bool is_inner = std::binary_search(inner.begin(), inner.end(), coedge.edge);
        if (!coedge.degenerate && !is_inner) edges.insert(coedge.edge);
      }
    }
  }
  return edges;
}

EdgePlan wall_by(const Settings& settings) {
  EdgePlan plan;
  plan.condition = EdgeCondition::kWall;
  plan.first_height = settings.first_height;
  plan.growth = settings.growth;
  plan.layers = settings.end == EndOfGrowth::kLayers ? settings.layers : kUntilClosed;
  return plan;
}

bool concerns(const WallSpec& spec, const std::vector<FaceId>& faces) {
  return spec.faces.empty() || std::any_of(faces.begin(), faces.end(), [&spec](FaceId face) {
           return std::find(spec.faces.begin(), spec.faces.end(), face) != spec.faces.end();
         });
}

void apply_spec(const WallSpec& spec, const Settings& settings, const EdgeSet& boundary,
                WallPlan& walls) {
  for (const EdgeId edge : spec.edges) {
    if (boundary.count(edge) == 0) continue;
    EdgePlan plan = wall_by(settings);
    if (spec.first_height) plan.first_height = *spec.first_height;
    if (spec.growth) plan.growth = *spec.growth;
    if (spec.layers) plan.layers = *spec.layers > 0 ? *spec.layers : kUntilClosed;
    walls.edges[edge] = plan;
  }
}

// The edges that no wall was asked of run along the layers where they meet a wall.
void match_beside_walls(const Model& model, WallPlan& walls) {
  std::unordered_set<VertexId> touched;
  for (const auto& [edge, plan] : walls.edges) {
    if (plan.condition != EdgeCondition::kWall) continue;
    for (const VertexId end : {model.edge(edge).start, model.edge(edge).end}) {
      if (end.valid()) touched.insert(end);
    }
  }
  for (auto& [edge, plan] : walls.edges) {
    if (plan.condition != EdgeCondition::kOff) continue;
    const Edge& shape = model.edge(edge);
    if (touched.count(shape.start) + touched.count(shape.end) > 0) {
      plan.condition = EdgeCondition::kMatch;
    }
  }
}

}  // namespace

std::vector<std::vector<FaceId>> group_faces(const Model& model, const Settings& settings) {
  std::vector<FaceId> faces = settings.faces;
  if (faces.empty()) {
    for (std::size_t i = 0; i < model.faces().size(); ++i) faces.emplace_back(i);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<std::vector<FaceId>> patches;
  for (const FaceId face : faces) patches.push_back({face});
  return patches;
}

WallPlan plan_walls(Evaluator& evaluator, const Settings& settings,
                    const std::vector<FaceId>& faces) {
  WallPlan walls;
  walls.stop_at_isotropy = settings.end == EndOfGrowth::kIsotropic;
  walls.max_height = settings.size;
  const EdgeSet boundary = boundary_edges(evaluator, settings, faces);
  for (const EdgeId edge : boundary) {
    walls.edges[edge] = settings.walls_all ? wall_by(settings) : EdgePlan();
  }
  for (const WallSpec& spec : settings.walls) {
    if (concerns(spec, faces)) apply_spec(spec, settings, boundary, walls);
  }
  const auto override_with = [&walls](const std::vector<EdgeId>& edges, EdgeCondition condition) {
    for (const EdgeId edge : edges) {
      const auto found = walls.edges.find(edge);
      if (found == walls.edges.end()) continue;
      found->second = EdgePlan();
      found->second.condition = condition;
    }
  };
  override_with(settings.match_edges, EdgeCondition::kMatch);
  if (!settings.walls_all) match_beside_walls(evaluator.model(), walls);
  override_with(settings.off_edges, EdgeCondition::kOff);
  return walls;
}

std::string patch_name(const std::vector<FaceId>& faces) {
  std::string name = face_name(faces.front());
  if (faces.size() > 1) name += " and " + std::to_string(faces.size() - 1) + " more";
  return name;
}

}  // namespace advlayers
