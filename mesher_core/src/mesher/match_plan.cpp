#include "mesher/match_plan.h"

#include <cmath>
#include <map>

#include "mesh/triangle_measures.h"

namespace advlayers {
namespace {

constexpr double kDegree = M_PI / 180.0;
// Layers do not run along an edge that is more slant than this.
constexpr double kLeastAngle = 45.0 * kDegree;
constexpr double kLargestAngle = 135.0 * kDegree;
constexpr double kChordPart = 1e-3;  // of the edge's range, where its tangent vanishes

// An edge as a face's boundary runs into a vertex or out of it.
struct Side {
  EdgeId edge;
  int end = 0;  // 0: the vertex is at the edge's first parameter
};

struct FaceCorner {
  FaceId face;
  Side in, out;
  double angle = 0.0;  // inside the face [rad]
};

// Unit direction in which the edge leaves one of its ends.
Vec3 direction_from(Evaluator& evaluator, Side side) {
  const Edge& edge = evaluator.model().edge(side.edge);
  const double t = side.end == 0 ? edge.first : edge.last;
  const double sign = side.end == 0 ? 1.0 : -1.0;
  const Vec3 tangent = sign * evaluator.edge_tangent(side.edge, t);
  if (tangent.norm() * (edge.last - edge.first) > 1e-6 * edge.length) return tangent.normalized();
  const double beside = t + sign * kChordPart * (edge.last - edge.first);
  return (evaluator.edge_point(side.edge, beside) - evaluator.edge_point(side.edge, t))
      .normalized();
}

FaceCorner corner_between(Evaluator& evaluator, FaceId face, const CoEdge& in, const CoEdge& out) {
  FaceCorner corner{face, {in.edge, in.forward ? 1 : 0}, {out.edge, out.forward ? 0 : 1}};
  const Edge& edge = evaluator.model().edge(out.edge);
  const Vec2 uv = evaluator.edge_uv(face, out, out.forward ? edge.first : edge.last);
  const Vec3 normal = evaluator.frame(face, uv.x(), uv.y()).normal;
  corner.angle = turn_angle(direction_from(evaluator, corner.out),
                            direction_from(evaluator, corner.in), normal);
  return corner;
}

std::vector<FaceCorner> corners_of(Evaluator& evaluator, const std::vector<FaceId>& faces) {
  std::vector<FaceCorner> corners;
  for (const FaceId face : faces) {
    for (const auto& loop : evaluator.model().face(face).loops) {
      std::vector<const CoEdge*> run;
      for (const CoEdge& coedge : loop) {
        if (!coedge.degenerate) run.push_back(&coedge);
      }
      for (std::size_t k = 0; k < run.size(); ++k) {
        corners.push_back(corner_between(evaluator, face, *run[k], *run[(k + 1) % run.size()]));
      }
    }
  }
  return corners;
}

class MatchPlanner {
 public:
  MatchPlanner(Evaluator& evaluator, const WallPlan& walls)
      : evaluator_(evaluator), walls_(walls) {}

  MatchPlan run(const std::vector<FaceId>& faces) {
    if (has(EdgeCondition::kMatch) && has(EdgeCondition::kWall)) {
      const std::vector<FaceCorner> corners = corners_of(evaluator_, faces);
      for (const FaceCorner& corner : corners) follow(corner, corners);
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
  const EdgePlan* plan_of(EdgeId edge) const {
    const auto found = walls_.edges.find(edge);
    return found == walls_.edges.end() ? nullptr : &found->second;
  }

  // From a boundary edge about its vertex, over the edges inside the patch, to the next one.
  void follow(FaceCorner corner, const std::vector<FaceCorner>& corners) {
    if (plan_of(corner.in.edge) == nullptr) return;
    for (std::size_t k = 0; k < corners.size() && plan_of(corner.out.edge) == nullptr; ++k) {
      const FaceCorner* beyond = nullptr;
      for (const FaceCorner& c : corners) {
        if (c.in.edge == corner.out.edge && c.in.end == corner.out.end) beyond = &c;
      }
      if (beyond == nullptr) return;
      corner.out = beyond->out;
      corner.angle += beyond->angle;
    }
    const EdgePlan *in = plan_of(corner.in.edge), *out = plan_of(corner.out.edge);
    if (out == nullptr) return;
    if (in->condition == EdgeCondition::kWall) add(corner, corner.in, *in, corner.out, *out);
    if (out->condition == EdgeCondition::kWall) add(corner, corner.out, *out, corner.in, *in);
  }

  void add(const FaceCorner& corner, Side wall, const EdgePlan& plan, Side along,
           const EdgePlan& other) {
    if (other.condition != EdgeCondition::kMatch) return;
    if (corner.angle < kLeastAngle || corner.angle > kLargestAngle) {
      note(corner, wall.edge, along.edge);
      return;
    }
    MatchEnd end;
    end.edge = along.edge;
    end.end = along.end;
    end.wall = wall.edge;
    end.wall_end = wall.end;
    end.face = corner.face;
    end.spacing = {plan.first_height, plan.growth, plan.layers, plan.rule};
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

  Evaluator& evaluator_;
  const WallPlan& walls_;
  MatchPlan plan_;
};

}  // namespace

MatchPlan plan_matches(Evaluator& evaluator, const std::vector<FaceId>& faces,
                       const WallPlan& walls) {
  return MatchPlanner(evaluator, walls).run(faces);
}

}  // namespace advlayers
