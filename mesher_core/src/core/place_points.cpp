#include "core/place_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/edge_swaps.h"
#include "layers/reconnect.h"
#include "mesh/triangle_measures.h"

namespace advlayers {
namespace {

// In sizes, along the arms of a cross:
constexpr double kClear = 0.7;        // a point as near as that leaves no room for another
constexpr double kClearOfEdge = 0.5;  // nor does an edge of the border
constexpr double kSameLength = 0.05;  // that an arm's ends may differ by
constexpr double kLookAhead = 3.5;    // for the border, to divide what is left evenly
constexpr double kOnRay = 1e-7;       // sine of an angle that is none
constexpr double kAcross = 0.52;      // cosine of the angle that the border has to make there
constexpr double kMostOff = 0.3;      // from its triangle, in sides of that
constexpr double kRefined = 0.99;     // of the face's size: the spot itself asks for less
constexpr double kSameArc = 0.01;     // that its length may differ by from what was wanted
constexpr double kMostLeft = 0.5;     // that the surface may leave the tangent plane within an arm
// Points that are placed at most, in those that there is room for.
constexpr double kMostPoints = 4.0;
constexpr double kMorePoints = 1000.0;
constexpr std::size_t kMostFaces = 96;  // that are looked at about a point
constexpr int kMostSteps = 400;         // of a walk from triangle to triangle
// A point so near to an edge, in heights of the triangle, is put onto it.
constexpr double kOnEdge = 0.02;
constexpr std::size_t kCancelStride = 64;  // points of a front between looks at the run

enum class Role : char { kBackground, kBorder, kPlaced };

class Placer {
 public:
  Placer(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface, const CoreRoom& room,
         TargetSize& target, CoreField& field)
      : mesh_(mesh),
        surface_(surface),
        room_(room),
        target_(target),
        field_(field),
        context_(context),
        swaps_(mesh) {
    role_.assign(mesh.vertex_capacity(), Role::kBackground);
    round_.assign(mesh.vertex_capacity(), 0);
  }

  void run() {
    std::vector<VertexH> front;
    for (const VertexH v : room_.vertices) {
      if (!room_.on_border[v.index()]) continue;
      role_[v.index()] = Role::kBorder;
      front.push_back(v);
    }
    if (front.empty() && !room_.vertices.empty()) {
      front.push_back(room_.vertices.front());
      role_[front.front().index()] = Role::kPlaced;
    }
    std::vector<VertexH> next;
    const double most = kMostPoints * points_in_room() + kMorePoints;
    for (now_ = 1; !front.empty() && placed_ < most; ++now_) {
      next.clear();
      for (std::size_t i = 0; i < front.size(); ++i) {
        if (i % kCancelStride == 0) context_.check();
        spread_from(front[i], next);
      }
      front.swap(next);
    }
    remove_background();
  }

 private:
  struct Spot {
    SurfacePoint point;
    Vec3 normal;
    FaceH face;
    std::array<VertexH, 3> corners;
    std::array<double, 3> shares;
    Cross cross;
  };

  double points_in_room() const {
    double points = 0.0;
    for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
      const FaceH f(i);
      if (!mesh_.alive(f) || !is_in_room(mesh_, mesh_.halfedge(f))) continue;
      const HalfedgeH h = mesh_.halfedge(f);
      double area_of_one = 0.0;
      for (const HalfedgeH side : {h, mesh_.next(h), mesh_.prev(h)}) {
        const Cross& cross = field_.at(mesh_.to(side));
        area_of_one += cross.size_along * cross.size_across / 3.0;
      }
      const Vec3& a = mesh_.position(mesh_.from(h));
      const Vec3 cross =
          (mesh_.position(mesh_.to(h)) - a).cross(mesh_.position(mesh_.to(mesh_.next(h))) - a);
      points += 0.5 * cross.norm() / area_of_one;
    }
    return points;
  }

  void spread_from(VertexH p, std::vector<VertexH>& next) {
    const Cross cross = field_.at(p);
    if (!(cross.size_along > 0.0 && cross.size_across > 0.0)) return;
    const Vec3 normal = mesh_.data(p).normal;
    const Vec3 across = cross.across(normal);
    const double turn = 2.0 * M_PI / field_.arms();
    for (int k = 0; k < field_.arms(); ++k) {
      const Vec3 arm = std::cos(k * turn) * cross.size_along * cross.along +
                       std::sin(k * turn) * cross.size_across * across;
      if (is_taken(p, cross, arm, normal)) continue;
      Spot spot;
      const double length = arm.norm();
      if (!go_to(p, arm, length, spot)) continue;
      const bool turned = field_.arms() == 4 && spot.cross.is_across(arm, spot.normal);
      const double ahead = turned ? spot.cross.size_across : spot.cross.size_along;
      const double mean = 2.0 * length * ahead / (length + ahead);
      const double even = in_even_rows(p, arm, normal, mean);
      if (!(even > 0.0)) continue;
      if (std::abs(even - length) > kSameLength * length && !go_to(p, arm, even, spot)) continue;
      try_place(spot, next);
    }
  }

  // The length next to that wanted of which a whole number reaches the border ahead; 0 where it is
  // reached by one.
  double in_even_rows(VertexH p, const Vec3& arm, const Vec3& normal, double length) const {
    const double way = way_to_border(p, arm, normal, kLookAhead * length);
    if (!(way > 0.0)) return length;
    double rows = 1.0;
    while (rows * (rows + 1.0) * length * length < way * way) rows += 1.0;
    return rows > 1.0 ? way / rows : 0.0;
  }

  // Along the arm, seen in the tangent plane; 0 where it is longer than `most`, or no edge that
  // lies across ends it.
  double way_to_border(VertexH p, const Vec3& arm, const Vec3& normal, double most) const {
    const Vec3 x = arm.normalized(), y = normal.cross(x);
    const Vec3& origin = mesh_.position(p);
    HalfedgeH h = room_towards(mesh_, p, arm);
    if (!h.valid()) return 0.0;
    h = mesh_.next(h);
    for (int step = 0; step < kMostSteps; ++step) {
      const Vec3 right = mesh_.position(mesh_.from(h)) - origin;
      const Vec3 edge = mesh_.position(mesh_.to(h)) - origin - right;
      const double rise = edge.dot(y);
      const double share = rise > 0.0 ? std::clamp(-right.dot(y) / rise, 0.0, 1.0) : 0.5;
      const double way = (right + share * edge).dot(x);
      if (way > most) return 0.0;
      if (!is_room_edge(mesh_, h)) {
        return std::abs(edge.dot(x)) < kAcross * edge.norm() ? way : 0.0;
      }
      const HalfedgeH t = SurfaceMesh::twin(h);
      const Vec3 apex = mesh_.position(mesh_.to(mesh_.next(t))) - origin;
      h = apex.dot(y) > -kOnRay * apex.norm() ? mesh_.next(t) : mesh_.prev(t);
    }
    return 0.0;
  }

  bool go_to(VertexH p, const Vec3& arm, double length, Spot& spot) {
    if (!land(p, length / arm.norm() * arm, spot)) return false;
    const double way = arc_to(p, spot);
    const bool near = std::abs(way - length) < kSameArc * length;
    if (!near && !land(p, length * length / (way * arm.norm()) * arm, spot)) return false;
    if (!find_face(p, arm, spot)) return false;
    spot.cross = field_.between(spot.corners, spot.shares, spot.normal);
    if (!target_.refined()) return true;
    const double most = target_.at(spot.point);
    const double longer = std::max(spot.cross.size_along, spot.cross.size_across);
    const bool refined_here = most < kRefined * target_.extent(spot.point.face);
    if (!refined_here || longer <= most) return true;
    spot.cross.size_along *= most / longer;
    spot.cross.size_across *= most / longer;
    return true;
  }

  bool land(VertexH p, const Vec3& offset, Spot& spot) {
    const Vec3 goal = mesh_.position(p) + offset;
    if (!surface_.project(goal, mesh_.data(p).point, spot.point)) return false;
    spot.normal = surface_.normal(spot.point);
    return (spot.point.xyz - goal).norm() < kMostLeft * offset.norm();
  }

  // Along the surface, as along a circle.
  double arc_to(VertexH p, const Spot& spot) const {
    const double turn2 = (spot.normal - mesh_.data(p).normal).squaredNorm();
    return (spot.point.xyz - mesh_.position(p)).norm() * (1.0 + turn2 / 24.0);
  }

  // Whether a neighbour stands where the arm ends already, seen in the tangent plane.
  bool is_taken(VertexH p, const Cross& cross, const Vec3& arm, const Vec3& normal) const {
    const Vec3 end = mesh_.position(p) + arm;
    const HalfedgeH first = mesh_.outgoing(p);
    HalfedgeH h = first;
    do {
      const VertexH w = mesh_.to(h);
      if (role_of(w) != Role::kBackground &&
          field_.reach(cross, mesh_.position(w) - end, normal) < kClear) {
        return true;
      }
      h = mesh_.rotate_cw(h);
    } while (h != first);
    return false;
  }

  Role role_of(VertexH v) const {
    return v.index() < role_.size() ? role_[v.index()] : Role::kBorder;
  }

  double side_of(HalfedgeH h, const Vec3& xyz, const Vec3& normal) const {
    const Vec3& a = mesh_.position(mesh_.from(h));
    const Vec3& b = mesh_.position(mesh_.to(h));
    const Vec3 up = normal + mesh_.data(mesh_.from(h)).normal + mesh_.data(mesh_.to(h)).normal;
    return (b - a).cross(xyz - a).dot(up) / up.norm();
  }

  // The triangle of the room that holds the spot, by a walk from one about p.
  bool find_face(VertexH p, const Vec3& arm, Spot& spot) {
    HalfedgeH h = room_towards(mesh_, p, arm);
    if (!h.valid()) return false;
    h = mesh_.next(h);
    HalfedgeH came = HalfedgeH();
    for (int step = 0; step < kMostSteps; ++step) {
      std::array<HalfedgeH, 3> sides = {h, mesh_.next(h), mesh_.prev(h)};
      std::array<double, 3> area{};
      int worst = -1;
      double total = 0.0;
      for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(k);
        area[i] = side_of(sides[i], spot.point.xyz, spot.normal);
        total += area[i];
        const Vec3 side = mesh_.position(mesh_.to(sides[i])) - mesh_.position(mesh_.from(sides[i]));
        if (sides[i] != came && area[i] < -kOnRay * side.squaredNorm() &&
            (worst < 0 || settled(area[i]) < settled(area[static_cast<std::size_t>(worst)]))) {
          worst = k;
        }
      }
      if (worst < 0) {
        if (!(total > 0.0)) return false;
        spot.face = mesh_.face(h);
        for (std::size_t k = 0; k < 3; ++k) {
          spot.corners[k] = mesh_.to(mesh_.next(sides[k]));
          spot.shares[k] = std::max(0.0, area[k]) / total;
        }
        return lies_on(spot);
      }
      const HalfedgeH out = sides[static_cast<std::size_t>(worst)];
      if (!is_room_edge(mesh_, out)) return false;
      came = h = SurfaceMesh::twin(out);
    }
    return false;
  }

  // The walk may end in a triangle of another sheet of the surface.
  bool lies_on(const Spot& spot) const {
    Vec3 foot = Vec3::Zero();
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      foot += spot.shares[k] * mesh_.position(spot.corners[k]);
      longest = std::max(
          longest,
          (mesh_.position(spot.corners[k]) - mesh_.position(spot.corners[(k + 1) % 3])).norm());
    }
    return (foot - spot.point.xyz).norm() < kMostOff * longest;
  }

  void try_place(const Spot& spot, std::vector<VertexH>& next) {
    const Cross& cross = spot.cross;
    VertexH rival;
    if (!is_clear(spot, rival)) {
      if (rival.valid()) meet(rival, spot);
      return;
    }
    VertexData data;
    data.point = spot.point;
    data.normal = spot.normal;
    const VertexH v = insert(spot, data);
    if (!v.valid()) return;
    field_.set(v, cross);
    role_.resize(mesh_.vertex_capacity(), Role::kBackground);
    round_.resize(mesh_.vertex_capacity(), 0);
    share_.resize(mesh_.vertex_capacity(), 1);
    role_[v.index()] = Role::kPlaced;
    round_[v.index()] = now_;
    share_[v.index()] = 1;
    next.push_back(v);
    placed_ += 1.0;
  }

  // Looks at the triangles that reach into the square about the spot.
  bool is_clear(const Spot& spot, VertexH& rival) {
    const Cross& cross = spot.cross;
    const double size = std::max(cross.size_along, cross.size_across);
    faces_.clear();
    faces_.push_back(spot.face);
    bool is_free = true;
    double nearest = INFINITY;
    for (std::size_t i = 0; i < faces_.size() && i < kMostFaces; ++i) {
      HalfedgeH h = mesh_.halfedge(faces_[i]);
      for (int k = 0; k < 3; ++k, h = mesh_.next(h)) {
        const VertexH v = mesh_.to(h);
        const Role role = role_of(v);
        if (role != Role::kBackground) {
          const double r =
              settled(field_.reach(cross, mesh_.position(v) - spot.point.xyz, spot.normal));
          if (r < kClear) {
            is_free = false;
            if (r < nearest) {
              nearest = r;
              rival = role == Role::kPlaced && round_[v.index()] == now_ ? v : VertexH();
            }
          }
        }
        const double distance = distance_to_edge(mesh_, h, spot.point.xyz);
        const HalfedgeH t = SurfaceMesh::twin(h);
        if (!is_room_edge(mesh_, h)) {
          if (distance < kClearOfEdge * std::min(cross.size_along, cross.size_across)) {
            rival = VertexH();
            return false;
          }
          continue;
        }
        if (distance > 1.42 * kClear * size) continue;
        const FaceH beyond = mesh_.face(t);
        if (std::find(faces_.begin(), faces_.end(), beyond) == faces_.end()) {
          faces_.push_back(beyond);
        }
      }
    }
    // Where more triangles meet than can be looked at, no point is missed.
    return is_free && faces_.size() < kMostFaces;
  }

  // Two rows want the same point: it goes to the middle of what they ask for.
  void meet(VertexH v, const Spot& spot) {
    const double share = 1.0 / (1.0 + share_[v.index()]);
    const Vec3 goal = mesh_.position(v) + share * (spot.point.xyz - mesh_.position(v));
    SurfacePoint foot;
    if (!surface_.project(goal, mesh_.data(v).point, foot)) return;
    const Corner moved{foot.xyz, surface_.normal(foot)};
    const HalfedgeH first = mesh_.outgoing(v);
    HalfedgeH h = first;
    do {
      if (!(min_angle_tangent(moved, corner(mesh_, mesh_.to(h)),
                              corner(mesh_, mesh_.to(mesh_.next(h)))) > 0.01)) {
        return;
      }
      h = mesh_.rotate_cw(h);
    } while (h != first);
    mesh_.data(v).point = foot;
    mesh_.data(v).normal = moved.normal;
    ++share_[v.index()];
    swaps_.enlist_about(v);
    swaps_.run();
  }

  VertexH insert(const Spot& spot, const VertexData& data) {
    const auto least = static_cast<std::size_t>(
        std::min_element(spot.shares.begin(), spot.shares.end()) - spot.shares.begin());
    VertexH v;
    if (spot.shares[least] < kOnEdge) {
      HalfedgeH h = mesh_.halfedge(spot.face);
      for (int k = 0; k < 3 && mesh_.to(mesh_.next(h)) != spot.corners[least]; ++k)
        h = mesh_.next(h);
      // The same half-edge from whichever side the walk came.
      h = std::min(h, SurfaceMesh::twin(h));
      if (mesh_.split_edge_veto(h) != Veto::kNone) return v;
      v = mesh_.split_edge(h, data);
    } else {
      v = mesh_.split_face(spot.face, data);
    }
    swaps_.enlist_about(v);
    swaps_.run();
    return v;
  }

  void remove_background() {
    VetoTally tally{};
    const ReconnectLimits limits;
    for (const VertexH v : room_.vertices) {
      if (role_[v.index()] != Role::kBackground) continue;
      context_.check();
      const HalfedgeH h = mesh_.outgoing(v);
      ring_.clear();
      HalfedgeH o = h;
      do {
        ring_.push_back(mesh_.to(o));
        o = mesh_.rotate_cw(o);
      } while (o != h);
      if (!remove_core_vertex(mesh_, v, Removal::kGuarded, limits, tally) &&
          !remove_core_vertex(mesh_, v, Removal::kForced, limits, tally)) {
        continue;
      }
      for (const VertexH w : ring_) swaps_.enlist_about(w);
      swaps_.run();
    }
  }

  SurfaceMesh& mesh_;
  PatchSurface& surface_;
  const CoreRoom& room_;
  TargetSize& target_;
  CoreField& field_;
  const RunContext& context_;
  EdgeSwaps swaps_;
  std::vector<Role> role_;  // by vertex
  std::vector<int> round_;  // that it was placed in
  std::vector<int> share_;  // rows that had a say in its place
  std::vector<FaceH> faces_;
  std::vector<VertexH> ring_;
  int now_ = 0;
  double placed_ = 0.0;
};

}  // namespace

void place_points(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const CoreRoom& room, TargetSize& target, CoreField& field) {
  Placer(context, mesh, surface, room, target, field).run();
}

}  // namespace advlayers
