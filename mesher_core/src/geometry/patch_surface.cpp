#include "geometry/patch_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace advlayers {

namespace {

constexpr int kEdgeSamples = 32;  // of an inner edge, in search of its nearest point
constexpr int kMaxFaces = 64;     // that one step may lead over
// Of a step, for the place where it leaves its face. What is left of it goes on from the foot on
// the neighbour, so that an error here enters the place squared.
constexpr int kBisections = 14;
// The trimmed regions are polygons within this part of a face's extent.
constexpr double kBlur = 1e-3;
constexpr double kLengthError = 1e-7;  // relative

struct Use {
  FaceId face;
  CoEdge coedge;
};

}  // namespace

PatchSurface::PatchSurface(Evaluator& evaluator, std::vector<FaceId> faces, const FeatureRule& rule)
    : evaluator_(&evaluator), faces_(std::move(faces)) {
  if (faces_.size() > 1) find_crossings(rule);
  faceted_ = has_facets(rule.smooth);
}

void PatchSurface::find_crossings(const FeatureRule& rule) {
  const Model& model = evaluator_->model();
  std::map<EdgeId, std::vector<Use>> uses;
  for (const FaceId f : faces_) {
    for (const auto& loop : model.face(f).loops) {
      for (const CoEdge& coedge : loop) uses[coedge.edge].push_back({f, coedge});
    }
  }
  for (const EdgeId id : advlayers::inner_edges(*evaluator_, faces_, rule)) {
    const std::vector<Use>& sides = uses[id];
    if (sides[0].face == sides[1].face) continue;  // a seam
    for (int k = 0; k < 2; ++k) {
      Crossing& crossing = crossings_.emplace_back();
      crossing.from = sides[static_cast<std::size_t>(k)].face;
      crossing.onto = sides[static_cast<std::size_t>(1 - k)].face;
      crossing.coedge = sides[static_cast<std::size_t>(1 - k)].coedge;
    }
  }
  std::stable_sort(crossings_.begin(), crossings_.end(),
                   [](const Crossing& a, const Crossing& b) { return a.from < b.from; });
}

std::pair<const PatchSurface::Crossing*, const PatchSurface::Crossing*>
PatchSurface::crossings_from(FaceId face) const {
  const Crossing* begin = crossings_.data();
  const Crossing* end = begin + crossings_.size();
  const Crossing* first = std::lower_bound(
      begin, end, face, [](const Crossing& crossing, FaceId f) { return crossing.from < f; });
  const Crossing* last = first;
  while (last != end && last->from == face) ++last;
  return {first, last};
}

// Most edges of a patch of very many faces are never asked for.
const std::vector<Vec3>& PatchSurface::points_along(const Crossing& crossing) {
  if (crossing.points.empty()) {
    for (int i = 0; i <= kEdgeSamples; ++i) {
      crossing.points.push_back(
          evaluator_->edge_point(crossing.coedge.edge, sample(crossing.coedge.edge, i)));
    }
  }
  return crossing.points;
}

double PatchSurface::sample(EdgeId id, int i) const {
  const Edge& edge = model().edge(id);
  return edge.first + (edge.last - edge.first) * i / kEdgeSamples;
}

// Distance to the edge, and the parameter there: from the samples, then by Gauss-Newton.
double PatchSurface::nearest(const Crossing& crossing, const Vec3& xyz, double& t) {
  const std::vector<Vec3>& points = points_along(crossing);
  const EdgeId id = crossing.coedge.edge;
  double best = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= kEdgeSamples; ++i) {
    const Vec3& a = points[static_cast<std::size_t>(i - 1)];
    const Vec3 ab = points[static_cast<std::size_t>(i)] - a;
    const double length2 = ab.squaredNorm();
    const double part = length2 > 0.0 ? std::clamp((xyz - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
    const double distance2 = (a + part * ab - xyz).squaredNorm();
    if (distance2 >= best) continue;
    best = distance2;
    t = sample(id, i - 1) + part * (sample(id, i) - sample(id, i - 1));
  }
  for (int i = 0; i < 3; ++i) {
    const Vec3 tangent = evaluator_->edge_tangent(id, t);
    const double speed2 = tangent.squaredNorm();
    if (!(speed2 > 0.0)) break;
    t += (xyz - evaluator_->edge_point(id, t)).dot(tangent) / speed2;
    t = std::clamp(t, sample(id, 0), sample(id, kEdgeSamples));
  }
  return (evaluator_->edge_point(id, t) - xyz).norm();
}

// `smooth` holds the edges that were decided by hand: these are no facets' edges.
bool PatchSurface::has_facets(const std::vector<EdgeId>& smooth) const {
  constexpr double kCoplanar = 1e-3;  // [rad]
  bool leaning = faces_.size() > 1 && model().triangular();
  for (const FaceId face : faces_) {
    if (model().face(face).kind != SurfaceKind::kPlane) return false;
  }
  for (const EdgeId edge : inner_edges()) {
    if (std::binary_search(smooth.begin(), smooth.end(), edge)) continue;
    leaning = leaning || model().dihedral_angle(edge) > kCoplanar;
  }
  return leaning;
}

std::vector<EdgeId> PatchSurface::inner_edges() const {
  std::vector<EdgeId> edges;
  for (const Crossing& crossing : crossings_) edges.push_back(crossing.coedge.edge);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

bool PatchSurface::nearest_between(FaceId a, FaceId b, const Vec3& xyz, InnerPoint& found) {
  double best = std::numeric_limits<double>::infinity();
  const auto [first, last] = crossings_from(a);
  for (const Crossing* it = first; it != last; ++it) {
    const Crossing& crossing = *it;
    if (crossing.onto != b) continue;
    double t = 0.0;
    const double distance = nearest(crossing, xyz, t);
    if (distance >= best) continue;
    best = distance;
    found.edge = crossing.coedge.edge;
    found.at_end = t <= sample(found.edge, 0) || t >= sample(found.edge, kEdgeSamples);
    const Vec2 uv = evaluator_->edge_uv(b, crossing.coedge, t);
    found.point = {b, uv.x(), uv.y(), evaluator_->edge_point(found.edge, t)};
  }
  return best < std::numeric_limits<double>::infinity();
}

// The foot on the neighbour, sought from the edge.
bool PatchSurface::cross(const Crossing& crossing, const Vec3& xyz, double t, SurfacePoint& foot) {
  const Vec2 uv = evaluator_->edge_uv(crossing.onto, crossing.coedge, t);
  return evaluator_->project(xyz, {crossing.onto, uv.x(), uv.y(), xyz}, foot);
}

bool PatchSurface::project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot) {
  const bool found = evaluator_->project(xyz, seed, foot);
  if (crossings_.empty()) return found;
  if (found && evaluator_->inside(foot.face, foot.u, foot.v)) return true;
  // Edges further away than the point has moved cannot have been crossed.
  const double reach = 1.5 * (xyz - seed.xyz).norm() + kBlur * (foot.xyz - seed.xyz).norm();
  std::vector<FaceId> met{seed.face};
  SurfacePoint best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < met.size() && !best.face.valid(); ++k) {
    const auto [first, last] = crossings_from(met[k]);
    for (const Crossing* it = first; it != last; ++it) {
      const Crossing& crossing = *it;
      double t = 0.0;
      const bool fresh = std::find(met.begin(), met.end(), crossing.onto) == met.end();
      if (!fresh || nearest(crossing, xyz, t) > reach) continue;
      met.push_back(crossing.onto);
      SurfacePoint other;
      if (!cross(crossing, xyz, t, other)) continue;
      const double distance = (other.xyz - xyz).norm();
      if (distance >= best_distance || !evaluator_->inside(other.face, other.u, other.v)) continue;
      best = other;
      best_distance = distance;
    }
  }
  if (!best.face.valid()) return found;
  foot = best;
  return true;
}

bool PatchSurface::settle(SurfacePoint& point) {
  if (crossings_.empty() || evaluator_->inside(point.face, point.u, point.v)) return true;
  SurfacePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (const Crossing& crossing : crossings_) {
    double t = 0.0;
    SurfacePoint other;
    if (nearest(crossing, point.xyz, t) >= 2.0 * least) continue;
    if (!cross(crossing, point.xyz, t, other)) continue;
    const double distance = (other.xyz - point.xyz).norm();
    if (distance >= least || !evaluator_->inside(other.face, other.u, other.v)) continue;
    least = distance;
    best = other;
  }
  if (!best.face.valid()) return false;
  point = best;
  return true;
}

bool PatchSurface::lands_inside(const SurfacePoint& from, double length, Vec3& heading,
                                SurfacePoint& to) {
  return evaluator_->walk(from, length, heading, to) && evaluator_->inside(to.face, to.u, to.v);
}

// How far the walk stays on the trimmed face.
double PatchSurface::find_exit(const SurfacePoint& from, const Vec3& heading, double length) {
  double inside = 0.0, outside = length;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (inside + outside);
    Vec3 unused = heading;
    SurfacePoint p;
    (lands_inside(from, middle, unused, p) ? inside : outside) = middle;
  }
  return outside;
}

const PatchSurface::Crossing* PatchSurface::crossing_at(const SurfacePoint& p, double reach,
                                                        EdgeId not_over, double& t) {
  const Crossing* found = nullptr;
  double best = reach;
  const auto [first, last] = crossings_from(p.face);
  for (const Crossing* crossing = first; crossing != last; ++crossing) {
    if (crossing->coedge.edge == not_over) continue;
    double t_near = 0.0;
    const double distance = nearest(*crossing, p.xyz, t_near);
    if (distance >= best) continue;
    best = distance;
    t = t_near;
    found = crossing;
  }
  return found;
}

bool PatchSurface::step(const SurfacePoint& from, const Vec3& direction, double length,
                        SurfacePoint& to) {
  const Vec3 normal = evaluator_->normal(from);
  Vec3 heading = direction - direction.dot(normal) * normal;
  const double size = heading.norm();
  if (!(size > 1e-9 * direction.norm())) return false;
  heading /= size;
  if (crossings_.empty()) return evaluator_->walk(from, length, heading, to);

  SurfacePoint at = from;
  double left = length;
  EdgeId came_over;
  for (int face = 0; face < kMaxFaces; ++face) {
    Vec3 ahead = heading;
    const bool arrived = evaluator_->walk(at, left, ahead, to);
    if (arrived && evaluator_->inside(to.face, to.u, to.v)) return true;
    const double exit = find_exit(at, heading, left);
    SurfacePoint end;
    if (!evaluator_->walk(at, exit, heading, end)) return arrived;
    // Just across an edge, the blurred face before it must not call the point back.
    const double blur = kBlur * std::sqrt(evaluator_->model().face(at.face).area);
    double t = 0.0;
    const Crossing* crossing = crossing_at(end, blur, exit < blur ? came_over : EdgeId(), t);
    SurfacePoint next;
    if (!crossing || !cross(*crossing, end.xyz, t, next)) return arrived;
    // Unfolds the faces about the edge, so that a crease turns nothing aside.
    const Vec3 n = evaluator_->normal(next);
    heading = Eigen::Quaterniond::FromTwoVectors(evaluator_->normal(end), n) * heading;
    heading = (heading - heading.dot(n) * n).normalized();
    came_over = crossing->coedge.edge;
    at = next;
    left -= exit;
    if (left <= kLengthError * length) {
      to = at;
      return true;
    }
  }
  return false;
}

}  // namespace advlayers
