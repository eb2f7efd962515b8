#include "triangulate/fill_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "base/angles.h"
#include "base/ties.h"
#include "triangulate/crease_splits.h"
#include "triangulate/initial_points.h"
#include "triangulate/sheet_room.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

// A triangle is done once its circumradius is at most this much of the equilateral one's.
constexpr double kRadiusLimit = 1.3;
// An edge whose length at the mean of its ends' metrics and at its middle's differ by this share is
// too long for either to be trusted.
constexpr double kMetricMismatch = 0.35;
constexpr double kLongestTurn = 70 * kDegree;  // of the normal along an edge, before all else
// Aimed at here; the bound after improvement in space is 30 degrees.
constexpr double kDeviation = 25 * kDegree;
// Shorter edges, as a share of the local size, are left to what follows.
constexpr double kShortestWide = 0.5;
constexpr double kSmallestSplit = 0.05;  // share of the local size that refinement stops at
constexpr double kLeastSplit = 0.1;      // and share of the least size
// Distance of an edge's middle from an apex, as a share of half the edge.
constexpr double kApexShare = 0.3;
constexpr double kOnEdge = 1e-7;  // of an edge's length: a point as near as that lies on it
// Share of a triangle's longest edge.
constexpr double kLongEnough = 0.8;
// Height over a boundary edge, as a share of the edge.
constexpr double kHugging = 0.02;
constexpr double kSagittas = 3;    // and of its sagitta
constexpr double kMostWide = 1e4;  // points that halving wide edges may make on any face
constexpr int kMostDivisions = 8;  // per triangle, on average

double local_size(const LiftedTriangulation& sheet, Side s) {
  return (sheet.vertex(sheet.mesh().from(s)).size + sheet.vertex(sheet.mesh().to(s)).size) / 2;
}

// Whether the middle of s lies so near to an apex that no good triangle comes of it, or so near to
// a boundary edge that the chord's sagitta would decide on the normal of the triangle between them.
bool middle_crowds(const LiftedTriangulation& sheet, Side s) {
  const PlanarTriangulation& mesh = sheet.mesh();
  const int a = mesh.from(s), b = mesh.to(s);
  const Vec2 p = (mesh.point(a) + mesh.point(b)) / 2;
  const Metric metric = (sheet.vertex(a).metric + sheet.vertex(b).metric) * 0.5;
  const double half2 = metric.squared(mesh.point(b) - p);
  for (const Side half : {s, mesh.opposite(s)}) {
    if (half.t < 0) continue;
    if (metric.squared(mesh.point(mesh.apex(half)) - p) < kApexShare * kApexShare * half2)
      return true;
    for (int i = 0; i < 3; ++i) {
      const Side side{half.t, i};
      if (mesh.segment(side) < 0) continue;
      const Metric& m = sheet.vertex(mesh.from(side)).metric;
      const Vec2 d = mesh.point(mesh.to(side)) - mesh.point(mesh.from(side));
      const Vec2 w = p - mesh.point(mesh.from(side));
      const double area = d.x() * w.y() - d.y() * w.x();
      const double length2 = m.squared(d);
      const double least =
          kHugging * std::sqrt(length2) + kSagittas * sheet.sagitta(mesh.segment(side));
      if (area * area * m.determinant() < least * least * length2) return true;
    }
  }
  return false;
}

// --- edges too long to be measured ---

bool spans_too_much(LiftedTriangulation& sheet, Side s) {
  const int a = sheet.mesh().from(s), b = sheet.mesh().to(s);
  const LiftedVertex &va = sheet.vertex(a), &vb = sheet.vertex(b);
  const Vec2 &pa = sheet.mesh().point(a), &pb = sheet.mesh().point(b);
  const LiftedVertex middle = sheet.evaluate((pa + pb) / 2);
  const double by_ends = std::sqrt(sheet.squared_length(a, b));
  const double by_middle = std::sqrt(middle.metric.squared(pb - pa));
  if (std::max(by_ends, by_middle) < kShortestWide * local_size(sheet, s)) return false;
  const double turn = std::min(
      {va.normal.dot(vb.normal), va.normal.dot(middle.normal), vb.normal.dot(middle.normal)});
  if (turn < std::cos(kLongestTurn)) return true;
  return std::max(by_ends, by_middle) > local_size(sheet, s) &&
         std::abs(by_ends - by_middle) > kMetricMismatch * std::max(by_ends, by_middle);
}

// Halves such edges; each is looked at again only after it changed. A surface that is torn, and
// jumps from place to place as the parameters hardly change, would be halved for ever: no more
// points are made than edges of the least length leave room for.
void split_wide_edges(const RunContext& context, LiftedTriangulation& sheet) {
  std::vector<int> pending(sheet.mesh().triangles().size());
  std::iota(pending.begin(), pending.end(), 0);
  const double least = sheet.least_size();
  const double most = sheet.mesh().point_count() + kMostWide + sheet.area() / (least * least);
  while (!pending.empty() && sheet.mesh().point_count() < most) {
    context.check();
    const int t = pending.back();
    pending.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Side s{t, i};
      if (sheet.mesh().segment(s) >= 0 || !spans_too_much(sheet, s) || middle_crowds(sheet, s)) {
        continue;
      }
      const Vec2 middle =
          (sheet.mesh().point(sheet.mesh().from(s)) + sheet.mesh().point(sheet.mesh().to(s))) / 2;
      if (sheet.insert_on(s, middle) < 0) continue;
      pending.insert(pending.end(), sheet.touched().begin(), sheet.touched().end());
      pending.push_back(t);
      break;
    }
  }
}

// --- frontal insertion ---

class FrontalInsertion {
 public:
  FrontalInsertion(const RunContext& context, LiftedTriangulation& sheet)
      : sheet_(sheet), context_(context) {}

  void run() {
    for (int t = 0; t < mesh().triangle_count(); ++t) assess(t);
    for (int t = 0; t < mesh().triangle_count(); ++t) push_if_active(t);
    while (!queue_.empty()) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (entry.version != sheet_.version(entry.t) || state(entry.t) <= kRadiusLimit) continue;
      context_.check();
      if (!insert_for(entry.t)) {
        settle(entry.t);
      }
    }
  }

 private:
  struct Entry {
    double radius;
    int t;
    unsigned version;
    bool operator<(const Entry& o) const {
      return radius != o.radius ? radius < o.radius : t > o.t;
    }
  };

  const PlanarTriangulation& mesh() const { return sheet_.mesh(); }
  double& state(int t) { return radius_[static_cast<std::size_t>(t)]; }

  // Circumradius over that of the equilateral triangle of the wanted size.
  double relative_radius(int t) const {
    const auto& v = mesh().triangle(t).v;
    const double a = sheet_.squared_length(v[1], v[2]), b = sheet_.squared_length(v[2], v[0]),
                 c = sheet_.squared_length(v[0], v[1]);
    const double sixteen_area2 = 2 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
    const double size =
        (sheet_.vertex(v[0]).size + sheet_.vertex(v[1]).size + sheet_.vertex(v[2]).size) / 3;
    if (sixteen_area2 <= 0) return std::numeric_limits<double>::infinity();
    return settled(std::sqrt(3 * a * b * c / sixteen_area2) / size);
  }

  void assess(int t) {
    if (static_cast<std::size_t>(t) >= radius_.size()) {
      radius_.resize(static_cast<std::size_t>(t) + 1, 0.0);
    }
    // Triangles that are nothing in space are done from the outset.
    state(t) = sheet_.vanishes(t) ? 0.0 : relative_radius(t);
  }

  bool is_open(Side s) {
    const int n = mesh().triangle(s.t).n[s.i];
    return n < 0 || mesh().segment(s) >= 0 || state(n) <= kRadiusLimit;
  }

  void push_if_active(int t) {
    if (state(t) <= kRadiusLimit) return;
    for (int i = 0; i < 3; ++i) {
      if (is_open({t, i})) {
        queue_.push({state(t), t, sheet_.version(t)});
        return;
      }
    }
  }

  // Nothing more can be done for t; its neighbours may start from it.
  void settle(int t) {
    state(t) = 0.0;
    for (const int n : mesh().triangle(t).n) {
      if (n >= 0) push_if_active(n);
    }
  }

  bool insert_for(int t) {
    std::array<Side, 3> sides{Side{t, 0}, Side{t, 1}, Side{t, 2}};
    std::array<double, 3> length{};
    for (int i = 0; i < 3; ++i) {
      length[i] = settled(sheet_.squared_length(mesh().from(sides[i]), mesh().to(sides[i])));
    }
    std::sort(sides.begin(), sides.end(), [&](Side a, Side b) {
      return length[a.i] != length[b.i] ? length[a.i] < length[b.i] : a.i < b.i;
    });
    for (const Side s : sides) {
      if (is_open(s) && insert_above(s)) return true;
    }
    return false;
  }

  // Where the apex of the best triangle on s lies: on the perpendicular bisector, at most as
  // far as the circumcenter.
  Vec2 ideal_apex(Side s) const {
    const int a = mesh().from(s), b = mesh().to(s), c = mesh().apex(s);
    const Metric m = (sheet_.vertex(a).metric + sheet_.vertex(b).metric) * 0.5;
    const Vec2 d = mesh().point(b) - mesh().point(a);
    const Vec2 middle = (mesh().point(a) + mesh().point(b)) / 2;
    const double length2 = m.squared(d), half = std::sqrt(length2) / 2;
    const double ab = sheet_.squared_length(a, b), bc = sheet_.squared_length(b, c),
                 ca = sheet_.squared_length(c, a);
    const double sixteen_area2 = 2 * (ab * bc + bc * ca + ca * ab) - (ab * ab + bc * bc + ca * ca);
    double radius = std::max(local_size(sheet_, s) / std::sqrt(3.0), half);
    if (sixteen_area2 > 0) {
      // Distance of the circumcenter from the edge; negative: behind it.
      const double q = (bc + ca - ab) / std::sqrt(sixteen_area2) * std::sqrt(ab) / 2;
      if (q > 0) radius = std::min(radius, (half * half + q * q) / (2 * q));
    }
    const double height = radius + std::sqrt(std::max(0.0, radius * radius - half * half));
    return middle + m.across(d) * (height / std::sqrt(length2));
  }

  // The inner edge that the point lies on but for round-off, from the same side wherever the walk
  // came from; none: t is -1.
  Side edge_under(int t, const Vec2& p) const {
    for (int i = 0; i < 3; ++i) {
      const Side s{t, i};
      const Vec2 d = mesh().point(mesh().to(s)) - mesh().point(mesh().from(s));
      const Vec2 w = p - mesh().point(mesh().from(s));
      if (std::abs(d.x() * w.y() - d.y() * w.x()) > kOnEdge * d.squaredNorm()) continue;
      if (mesh().segment(s) >= 0) continue;
      const Side o = mesh().opposite(s);
      return o.t >= 0 && o.t < s.t ? o : s;
    }
    return {-1, 0};
  }

  bool insert_above(Side s) {
    const Vec2 p = ideal_apex(s);
    const int t = walk_to(mesh(), s.t, p);
    if (t < 0 || crowds(sheet_, t, p)) return false;
    const Side on = edge_under(t, p);
    if (on.t >= 0 && (crowds(sheet_, on.t, p) || crowds(sheet_, mesh().opposite(on).t, p))) {
      return false;
    }
    if ((on.t >= 0 ? sheet_.insert_on(on, p) : sheet_.insert_in(t, p)) < 0) return false;
    for (const int touched : sheet_.touched()) assess(touched);
    for (const int touched : sheet_.touched()) {
      push_if_active(touched);
      if (state(touched) > kRadiusLimit) continue;
      for (const int n : mesh().triangle(touched).n) {
        if (n >= 0) push_if_active(n);
      }
    }
    return true;
  }

  LiftedTriangulation& sheet_;
  const RunContext& context_;
  std::priority_queue<Entry> queue_;
  std::vector<double> radius_;
};

// --- triangles that leave the surface ---

double worst_deviation_cosine(LiftedTriangulation& sheet, int t) {
  const auto& v = sheet.mesh().triangle(t).v;
  const LiftedVertex &a = sheet.vertex(v[0]), &b = sheet.vertex(v[1]), &c = sheet.vertex(v[2]);
  const Vec3 cross = (b.point.xyz - a.point.xyz).cross(c.point.xyz - a.point.xyz);
  const double area = cross.norm();
  if (area == 0) return 1;
  double worst = 1;
  for (const LiftedVertex* corner : {&a, &b, &c}) {
    if (!corner->pole && !corner->crease) worst = std::min(worst, cross.dot(corner->normal) / area);
  }
  const Vec2 center =
      (sheet.mesh().point(v[0]) + sheet.mesh().point(v[1]) + sheet.mesh().point(v[2])) / 3;
  return std::min(worst, cross.dot(sheet.evaluate(center).normal) / area);
}

// The free edge along which the normal turns most, of those that are long enough to matter: a short
// side of a thin triangle is not what tilts it.
Side edge_to_divide(const LiftedTriangulation& sheet, int t) {
  std::array<double, 3> length2{};
  for (int i = 0; i < 3; ++i) {
    length2[i] = sheet.squared_length(sheet.mesh().from({t, i}), sheet.mesh().to({t, i}));
  }
  const double longest2 = *std::max_element(length2.begin(), length2.end());
  Side best;
  double best_turn = std::cos(5 * kDegree);
  for (int i = 0; i < 3; ++i) {
    const Side s{t, i};
    if (sheet.vertex(sheet.mesh().from(s)).crease || sheet.vertex(sheet.mesh().to(s)).crease)
      continue;
    if (sheet.mesh().segment(s) >= 0 || length2[i] < kLongEnough * kLongEnough * longest2) continue;
    const double limit =
        std::max(2 * kSmallestSplit * local_size(sheet, s), kLeastSplit * sheet.least_size());
    const double turn =
        sheet.vertex(sheet.mesh().from(s)).normal.dot(sheet.vertex(sheet.mesh().to(s)).normal);
    if (turn >= best_turn || length2[i] < limit * limit) continue;
    best_turn = turn;
    best = s;
  }
  return best;
}

void refine_deviating(const RunContext& context, LiftedTriangulation& sheet) {
  std::vector<int> pending(sheet.mesh().triangles().size());
  std::iota(pending.begin(), pending.end(), 0);
  const int limit = sheet.mesh().point_count() + kMostDivisions * sheet.mesh().triangle_count();
  while (!pending.empty() && sheet.mesh().point_count() < limit) {
    context.check();
    const int t = pending.back();
    pending.pop_back();
    if (worst_deviation_cosine(sheet, t) > std::cos(kDeviation)) continue;
    const Side s = edge_to_divide(sheet, t);
    if (s.t < 0 || middle_crowds(sheet, s)) continue;
    const Vec2 middle =
        (sheet.mesh().point(sheet.mesh().from(s)) + sheet.mesh().point(sheet.mesh().to(s))) / 2;
    if (sheet.insert_on(s, middle) < 0) continue;
    pending.insert(pending.end(), sheet.touched().begin(), sheet.touched().end());
  }
}

}  // namespace

int fill_sheet(const RunContext& context, LiftedTriangulation& sheet,
               const std::vector<SurfacePoint>& initial) {
  sheet.flip_all();
  const int taken = insert_initial_points(context, sheet, initial);
  split_wide_edges(context, sheet);
  FrontalInsertion(context, sheet).run();
  split_creases(context, sheet);
  sheet.straighten_poles();
  refine_deviating(context, sheet);
  sheet.straighten_poles();
  sheet.put_in_order(context);
  return taken;
}

}  // namespace advlayers
