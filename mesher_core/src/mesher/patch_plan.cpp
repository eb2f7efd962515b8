#include "mesher/patch_plan.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
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

bool contains(const std::vector<FaceId>& faces, FaceId face) {
  return std::find(faces.begin(), faces.end(), face) != faces.end();
}

// Whether the wall is asked for on a side of the edge that belongs to the patch.
bool concerns(const WallSpec& spec, const Model& model, const std::vector<FaceId>& faces,
              EdgeId edge) {
  if (spec.faces.empty()) return true;
  const auto& sides = model.edge(edge).faces;
  return std::any_of(sides.begin(), sides.end(), [&](FaceId face) {
    return contains(faces, face) && contains(spec.faces, face);
  });
}

void apply_spec(const WallSpec& spec, const Settings& settings, const Model& model,
                const std::vector<FaceId>& faces, WallPlan& walls) {
  for (const EdgeId edge : spec.edges) {
    if (walls.edges.count(edge) == 0 || !concerns(spec, model, faces, edge)) continue;
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
  std::vector<FaceId> sound;
  std::copy_if(faces.begin(), faces.end(), std::back_inserter(sound),
               [&model](FaceId face) { return model.face(face).defect.empty(); });
  std::vector<FaceId> leader(model.faces().size());  // of the face's patch: its first face
  for (const FaceId face : faces) leader[face.index()] = face;
  const auto leader_of = [&leader](FaceId face) {
    while (leader[face.index()] != face) face = leader[face.index()];
    return face;
  };
  Evaluator evaluator(model);
  for (const EdgeId edge : inner_edges(evaluator, sound, settings.feature_angle)) {
    const auto& sides = model.edge(edge).faces;
    if (sides.size() != 2) continue;
    const auto [first, second] = std::minmax({leader_of(sides[0]), leader_of(sides[1])});
    leader[second.index()] = first;
  }
  std::map<FaceId, std::vector<FaceId>> patches;
  for (const FaceId face : faces) patches[leader_of(face)].push_back(face);
  std::vector<std::vector<FaceId>> groups;
  for (auto& [first, group] : patches) groups.push_back(std::move(group));
  return groups;
}

FaceId face_beside(const Model& model, const std::vector<FaceId>& faces, EdgeId edge) {
  for (const FaceId face : model.edge(edge).faces) {
    if (contains(faces, face)) return face;
  }
  return faces.front();
}

WallPlan plan_walls(Evaluator& evaluator, const Settings& settings,
                    const std::vector<FaceId>& faces) {
  WallPlan walls;
  walls.stop_at_isotropy = settings.end == EndOfGrowth::kIsotropic;
  walls.max_height = settings.size;
  for (const EdgeId edge : boundary_edges(evaluator, settings, faces)) {
    walls.edges[edge] = settings.walls_all ? wall_by(settings) : EdgePlan();
  }
  for (const WallSpec& spec : settings.walls) {
    apply_spec(spec, settings, evaluator.model(), faces, walls);
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
