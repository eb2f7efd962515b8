#include "core/star_smoothing.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace advlayers {
namespace {

// A move below this part of the mean edge length is as good as none.
constexpr double kLeastMove = 0.02;
constexpr std::size_t kLargestStar = 24;
constexpr std::size_t kCancelStride = 256;

// An element about the vertex: the corners after it, counter-clockwise, relative to it, in the
// plane that touches the surface there. A triangle has no d.
struct Sector {
  Vec2 b, c, d;
  double weight_b = 1.0, weight_d = 1.0;  // of the sides along b and d
  bool quad = false;
};

struct Star {
  std::array<Sector, kLargestStar> sectors;
  std::size_t count = 0;
  double mean_side = 0.0;
  double area_floor = 0.0;
  Vec3 x_axis, y_axis;
};

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

void choose_axes(const Vec3& normal, Star& star) {
  const Vec3 helper = std::abs(normal.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
  star.x_axis = normal.cross(helper).normalized();
  star.y_axis = normal.cross(star.x_axis);
}

// Weights under which a rectangle of the quad's mean sides costs least.
void weigh_sides(Sector& s) {
  const double along_b = s.b.norm() + (s.c - s.d).norm();
  const double along_d = s.d.norm() + (s.c - s.b).norm();
  if (along_b <= 0.0 || along_d <= 0.0) return;
  s.weight_b = along_d / along_b;
  s.weight_d = along_b / along_d;
}

bool gather(const SurfaceMesh& mesh, VertexH v, QuadTarget target, Star& star) {
  choose_axes(mesh.data(v).normal, star);
  const Vec3 origin = mesh.position(v);
  const auto flat = [&](VertexH w) {
    const Vec3 offset = mesh.position(w) - origin;
    return Vec2(offset.dot(star.x_axis), offset.dot(star.y_axis));
  };
  double sides = 0.0;
  for (const HalfedgeH h : mesh.around_ccw(v)) {
    if (star.count == kLargestStar) return false;
    Sector& sector = star.sectors[star.count++];
    const HalfedgeH bc = mesh.next(h), beyond = mesh.next(bc);
    sector.b = flat(mesh.to(h));
    sector.c = flat(mesh.to(bc));
    sector.quad = mesh.next(beyond) != h;
    if (sector.quad) sector.d = flat(mesh.to(beyond));
    if (sector.quad && target == QuadTarget::kRectangle) weigh_sides(sector);
    sides += sector.b.norm();
  }
  star.mean_side = sides / static_cast<double>(star.count);
  star.area_floor = 1e-3 * star.mean_side * star.mean_side;
  return star.mean_side > 0.0;
}

// Calls visit(squares, gradient, curvature, area, area_gradient) for each corner that the vertex at
// p has a part in: its weighted squares of sides, with their gradient and Hessian (curvature times
// the identity) by p, and its area with its gradient, which p does not change.
template <class Visit>
void visit_corners(const Star& star, const Vec2& p, const Visit& visit) {
  for (std::size_t i = 0; i < star.count; ++i) {
    const Sector& s = star.sectors[i];
    const Vec2 b = s.b - p, bc = s.c - s.b;
    if (s.quad) {
      const Vec2 d = s.d - p, dc = s.c - s.d;
      const double wb = s.weight_b, wd = s.weight_d;
      visit(wb * b.squaredNorm() + wd * d.squaredNorm(), -2.0 * (wb * b + wd * d), 2.0 * (wb + wd),
            cross(b, d), Vec2(b.y() - d.y(), d.x() - b.x()));
      visit(wb * b.squaredNorm() + wd * bc.squaredNorm(), -2.0 * wb * b, 2.0 * wb, cross(bc, -b),
            Vec2(-bc.y(), bc.x()));
      visit(wd * d.squaredNorm() + wb * dc.squaredNorm(), -2.0 * wd * d, 2.0 * wd, cross(-d, dc),
            Vec2(dc.y(), -dc.x()));
    } else {
      // All three sides over the area: 1 for equal sides with this factor.
      constexpr double kEquilateral = 1.0 / 1.7320508075688772;
      const Vec2 c = s.c - p;
      visit(kEquilateral * (b.squaredNorm() + c.squaredNorm() + bc.squaredNorm()),
            kEquilateral * -2.0 * (b + c), kEquilateral * 4.0, cross(b, c),
            Vec2(b.y() - c.y(), c.x() - b.x()));
    }
  }
}

// The area of a corner, bent below the floor so as to stay positive: a folded corner is pulled
// open. `slope` is the derivative by the true area.
double positive_area(double area, double floor, double& slope) {
  slope = 1.0;
  if (area >= 4.0 * floor) return area;
  const double root = std::sqrt(area * area + floor * floor);
  slope = 0.5 * (1.0 + area / root);
  return 0.5 * (area + root);
}

double cost_at(const Star& star, const Vec2& p) {
  double sum = 0.0;
  visit_corners(star, p, [&](double squares, const Vec2&, double, double area, const Vec2&) {
    double slope = 1.0;
    const double f = 0.5 * squares / positive_area(area, star.area_floor, slope);
    sum += f * f;
  });
  return sum;
}

struct Cost {
  double value = 0.0;
  Vec2 gradient = Vec2::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
};

Cost cost_here(const Star& star) {
  Cost cost;
  visit_corners(
      star, Vec2::Zero(),
      [&](double squares, const Vec2& squares_gradient, double curvature, double area,
          const Vec2& area_gradient) {
        double slope = 1.0;
        const double inverse = 0.5 / positive_area(area, star.area_floor, slope);
        const Vec2 da = slope * area_gradient;
        const double f = squares * inverse;
        const Vec2 df = (squares_gradient - 2.0 * f * da) * inverse;
        const Eigen::Matrix2d mixed = df * da.transpose();
        const Eigen::Matrix2d ddf =
            (curvature * Eigen::Matrix2d::Identity() - 2.0 * (mixed + mixed.transpose())) * inverse;
        cost.value += f * f;
        cost.gradient += 2.0 * f * df;
        cost.hessian += 2.0 * (df * df.transpose() + f * ddf);
      });
  return cost;
}

// One damped Newton step; more would be spent on neighbours that are yet to move. False where the
// vertex is as good as at the minimum.
bool find_better_place(const Star& star, Vec2& place) {
  const Cost cost = cost_here(star);
  const bool convex = cost.hessian(0, 0) > 0.0 && cost.hessian.determinant() > 0.0;
  place = convex ? Vec2(-cost.hessian.inverse() * cost.gradient)
                 : Vec2(-cost.gradient / (cost.hessian.norm() + 1e-300));
  const double limit = 0.5 * star.mean_side;
  if (place.norm() > limit) place *= limit / place.norm();
  const double least = kLeastMove * star.mean_side;
  for (; place.norm() > least; place *= 0.5) {
    if (cost_at(star, place) < cost.value) return true;
  }
  return false;
}

// True where the vertex moved noticeably.
bool smooth_star(SurfaceMesh& mesh, PatchSurface& surface, QuadTarget target, VertexH v) {
  Star star;
  if (!gather(mesh, v, target, star)) return false;
  Vec2 place;
  if (!find_better_place(star, place)) return false;
  VertexData& data = mesh.data(v);
  const Vec3 goal = data.point.xyz + place.x() * star.x_axis + place.y() * star.y_axis;
  SurfacePoint foot;
  if (!surface.project(goal, data.point, foot)) return false;
  if ((foot.xyz - goal).norm() > 0.5 * star.mean_side) return false;
  if (!keeps_faces_upright(mesh, v, foot.xyz)) return false;
  data.point = foot;
  data.normal = surface.normal(foot);
  return true;
}

}  // namespace

bool keeps_faces_upright(const SurfaceMesh& mesh, VertexH v, const Vec3& place) {
  const Vec3& normal = mesh.data(v).normal;
  for (const HalfedgeH h : mesh.around_ccw(v)) {
    const HalfedgeH last = mesh.prev(h);
    const Vec3& at_b = mesh.position(mesh.to(h));
    const Vec3& at_d = mesh.position(mesh.from(last));
    const Vec3& after_b = mesh.position(mesh.to(mesh.next(h)));
    const Vec3& before_d = mesh.position(mesh.from(mesh.prev(last)));
    const Vec3 b = at_b - place, d = at_d - place;
    // For a triangle after_b is d, and this is its own normal; for a quad it is its area's.
    const Vec3 area = mesh.is_triangle(h) ? b.cross(d) : (after_b - place).cross(at_d - at_b);
    if (area.dot(normal) <= 0.0 || b.cross(d).dot(area) <= 0.0) return false;
    if (b.cross(after_b - at_b).dot(area) <= 0.0) return false;
    if ((at_d - before_d).cross(-d).dot(area) <= 0.0) return false;
    if (!mesh.is_triangle(h) && (after_b - at_b).cross(at_d - after_b).dot(area) <= 0.0) {
      return false;
    }
  }
  return true;
}

void smooth_stars(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const std::vector<VertexH>& movable, QuadTarget target, int sweeps) {
  std::vector<char> waiting(mesh.vertex_capacity(), 0);
  for (const VertexH v : movable) waiting[v.index()] = 1;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::size_t moved = 0;
    for (std::size_t i = 0; i < movable.size(); ++i) {
      if (i % kCancelStride == 0) context.check();
      const VertexH v = movable[i];
      if (!waiting[v.index()] || !mesh.alive(v)) continue;
      waiting[v.index()] = 0;
      if (!smooth_star(mesh, surface, target, v)) continue;
      ++moved;
      waiting[v.index()] = 1;
      for (const HalfedgeH h : mesh.around_ccw(v)) {
        waiting[mesh.to(h).index()] = 1;
        waiting[mesh.to(mesh.next(h)).index()] = 1;
      }
    }
    if (moved == 0) break;
  }
}

}  // namespace advlayers
