#include "mesher/patch_plan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_set>

#include "geometry/patch_edges.h"
#include "mesher/walls_run_on.h"
#include "sizing/size_field.h"

namespace advlayers {
namespace {

using EdgeSet = std::unordered_set<EdgeId>;

// Every edge that bounds the patch: of all faces, but degenerate and inner ones.
EdgeSet boundary_edges(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                       const std::vector<FaceId>& faces) {
  const auto inner = inner_edges(evaluator, faces, feature_rule(settings));
  EdgeSet edges;
  for (const FaceId face : faces) {
    context.check();
    for (const auto& loop : evaluator.model().face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const bool is_inner = std::binary_search(inner.begin(), inner.end(), coedge.edge);
        if (!coedge.degenerate && !is_inner) edges.insert(coedge.edge);
      }
    }
  }
  return edges;
}

// Of the mesh edges along a wall to its first height, where small parts have sizes of their own.
constexpr double kLocalAspect = 10.0;

EdgePlan wall_by(WallSpec spec, const Settings& settings) {
  const bool own = spec.first_height || spec.end_height || spec.aspect_ratio ||
                   spec.turning_angle || spec.thickness || spec.thickness_share;
  const bool high = settings.first_height >= 0.999 * settings.size / kLocalAspect;
  if (!own && high && settings.cells_across > 0) spec.aspect_ratio = kLocalAspect;
  const WallSpacing spacing = spacing_of(spec, settings);
  return {
      EdgeCondition::kWall, {spacing.first_height, spacing.growth, spacing.layers}, spacing.rule};
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

void apply_spec(const RunContext& context, const WallSpec& spec, const Settings& settings,
                const Model& model, const std::vector<FaceId>& faces, WallPlan& walls) {
  for (const EdgeId edge : spec.edges) {
    context.check();
    if (walls.edges.count(edge) == 0 || !concerns(spec, model, faces, edge)) continue;
    WallSpec here = spec;
    if (spec.thickness_share) {
      here.thickness =
          *spec.thickness_share * SizeField(settings).of_edge(edge, model.edge(edge).faces);
      here.thickness_share.reset();
    }
    walls.edges[edge] = wall_by(here, settings);
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

std::vector<std::vector<FaceId>> group_faces(const RunContext& context, const Model& model,
                                             const Settings& settings) {
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
    while (leader[face.index()] != face) {
      leader[face.index()] = leader[leader[face.index()].index()];  // shorter for the next one
      face = leader[face.index()];
    }
    return face;
  };
  Evaluator evaluator(model);
  for (const EdgeId edge : inner_edges(evaluator, sound, feature_rule(settings))) {
    context.check();
    const auto& sides = model.edge(edge).faces;
    if (sides.size() != 2) continue;
    const auto [first, second] = std::minmax({leader_of(sides[0]), leader_of(sides[1])});
    leader[second.index()] = first;
  }
  std::map<FaceId, std::vector<FaceId>> patches;
  for (const FaceId face : faces) patches[leader_of(face)].push_back(face);
  std::vector<std::vector<FaceId>> groups;
  groups.reserve(patches.size());
  for (auto& [first, group] : patches) groups.push_back(std::move(group));
  return groups;
}

FaceId face_beside(const Model& model, const std::vector<FaceId>& faces, EdgeId edge) {
  for (const FaceId face : model.edge(edge).faces) {
    if (contains(faces, face)) return face;
  }
  return faces.front();
}

WallPlan plan_walls(const RunContext& context, Evaluator& evaluator, const Settings& settings,
                    const std::vector<FaceId>& faces) {
  WallPlan walls;
  walls.stop_at_isotropy = settings.end == EndOfGrowth::kIsotropic;
  const SizeField sizes(settings);
  walls.max_height = 0.0;
  for (const FaceId face : faces)
    walls.max_height = std::max(walls.max_height, sizes.of_face(face));
  for (const EdgeId edge : boundary_edges(context, evaluator, settings, faces)) {
    context.check();
    const bool wall = settings.walls_all || settings.others == OtherEdges::kWall;
    walls.edges[edge] = wall ? wall_by(WallSpec(), settings) : EdgePlan();
  }
  for (const WallSpec& spec : settings.walls) {
    apply_spec(context, spec, settings, evaluator.model(), faces, walls);
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
  const bool along = !settings.walls_all && settings.others == OtherEdges::kMatch;
  if (along) match_beside_walls(evaluator.model(), walls);
  override_with(settings.off_edges, EdgeCondition::kOff);
  if (along) run_walls_on(context, evaluator, settings, faces, walls);
  return walls;
}

void resolve_heights(const RunContext& context, Evaluator& evaluator,
                     const Discretization& boundary, WallPlan& walls) {
  for (auto& [edge, plan] : walls.edges) {
    plan.heights.clear();
    plan.heights_along.clear();
    if (plan.condition != EdgeCondition::kWall || !plan.rule.varies()) continue;
    const EdgeNodes& cut = boundary.edges[edge.index()];
    std::vector<double> lengths;  // of the mesh edges
    double total = 0.0;
    for (std::size_t k = 1; k < cut.nodes.size(); ++k) {
      context.check();
      lengths.push_back(evaluator.edge_length(edge, cut.params[k - 1], cut.params[k]));
      total += lengths.back();
    }
    const bool closed = cut.nodes.front() == cut.nodes.back();
    const WallSpacing spacing{plan.growth.height, plan.growth.ratio, plan.growth.layers_left,
                              plan.rule};
    double walked = 0.0;
    for (std::size_t k = 0; k < cut.nodes.size(); ++k) {
      context.check();
      const double before = k > 0 ? lengths[k - 1] : closed ? lengths.back() : lengths.front();
      const double after = k < lengths.size() ? lengths[k] : closed ? lengths.front() : before;
      WallPlace place;
      place.part = walked / total;
      place.segment = 0.5 * (before + after);
      place.curvature = evaluator.edge_curvature(edge, cut.params[k]);
      plan.heights_along.push_back(first_height_at(spacing, place, walls.max_height));
      plan.heights[cut.nodes[k]] = plan.heights_along.back();
      if (k < lengths.size()) walked += lengths[k];
    }
  }
}

std::string patch_name(const std::vector<FaceId>& faces) {
  std::string name = face_name(faces.front());
  if (faces.size() > 1) name += " and " + std::to_string(faces.size() - 1) + " more";
  return name;
}

}  // namespace advlayers
