#include "layers/smooth.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

// The paper's spring constants and bounds (II.I).
constexpr double kExtrusionSpring = 0.01;
constexpr double kNeighbourSpring = 0.02;
constexpr double kOriginalSpring = 0.1;
constexpr int kPasses = 8;
constexpr double kMostStep = 0.05;    // of the height, per pass
constexpr double kLeastAngle = 0.01;  // [rad] that a move may leave in an element beside it
constexpr double kVeryUneven = 1.3;   // at regular vertices of the first layers
constexpr double kUneven = 1.15;      // neighbour edges that differ more are worth smoothing
// Front edges of this many heights: no angle gains from a step along them, but heights lose.
constexpr double kFlat = 12.0;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Spring {
  int kid = -1, left = -1, right = -1;  // left and right along the new front
  Vec3 parent = Vec3::Zero(), original = Vec3::Zero();
  double height = 0.0;
};

bool is_regular(const LayerPlan& plan, const Kid& kid) {
  return kid.parents.size() == 1 && std::abs(plan.shapes[index(kid.origin)].turn()) < kRegularTurn;
}

std::vector<Spring> springs(const LayerState& state, const LayerPlan& plan) {
  std::vector<int> left(plan.kids.size(), -1), right(plan.kids.size(), -1);
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) continue;
    for (const auto& [p, q] : cell.fronts) {
      right[index(p)] = q;
      left[index(q)] = p;
    }
  }
  std::vector<Spring> result;
  for (std::size_t k = 0; k < plan.kids.size(); ++k) {
    const Kid& kid = plan.kids[k];
    const bool regular = state.layer <= kStraightLayers && is_regular(plan, kid);
    if (!kid.alive || left[k] < 0 || right[k] < 0 || kid.fan_age >= 0) continue;
    Spring spring{static_cast<int>(k), left[k], right[k]};
    const auto at = [&](int i) { return plan.kids[index(i)].point.xyz; };
    const double a = (at(left[k]) - kid.point.xyz).norm();
    const double b = (at(right[k]) - kid.point.xyz).norm();
    if (std::max(a, b) < (regular ? kVeryUneven : kUneven) * std::min(a, b)) continue;
    spring.parent = state.mesh.position(state.front[kid.origin].vertex);
    spring.original = kid.point.xyz;
    spring.height = (kid.point.xyz - spring.parent).norm();
    if (a + b > 2.0 * kFlat * spring.height) continue;
    result.push_back(spring);
  }
  return result;
}

Vec3 force(const SurfaceMesh& mesh, const LayerPlan& plan, const Spring& spring) {
  const auto at = [&](int k) { return mesh.position(plan.kids[index(k)].vertex); };
  const Vec3 here = at(spring.kid), left = at(spring.left), right = at(spring.right);
  const Vec3 along = (right - left).normalized();
  const Vec3 up = here - spring.parent;
  const double real = up.norm();
  const Vec3 parent_force =
      -kExtrusionSpring * (real - spring.height) / (real + spring.height) * up;
  const Vec3 neighbour_force = kNeighbourSpring * (0.5 * (left + right) - here).dot(along) * along;
  return parent_force + neighbour_force + kOriginalSpring * (spring.original - here);
}

// Every corner about v stays convex with v at `moved`.
bool stays_upright(const SurfaceMesh& mesh, VertexH v, const Corner& moved) {
  const auto at = [&](VertexH w) { return w == v ? moved : corner(mesh, w); };
  for (const HalfedgeH o : mesh.around(v)) {
    for (const HalfedgeH h : mesh.sides(o)) {
      const HalfedgeH n = mesh.next(h);
      const double angle = inner_angle(at(mesh.from(h)), at(mesh.to(h)), at(mesh.to(n)));
      if (angle < kLeastAngle || angle > M_PI - kLeastAngle) return false;
    }
  }
  return true;
}

}  // namespace

void smooth_layer(LayerState& state, const LayerPlan& plan) {
  SurfaceMesh& mesh = state.mesh;
  const std::vector<Spring> moving = springs(state, plan);
  for (int pass = 0; pass < kPasses; ++pass) {
    for (const Spring& spring : moving) {
      state.context.check();
      const VertexH v = plan.kids[index(spring.kid)].vertex;
      Vec3 step = force(mesh, plan, spring);
      const double most = kMostStep * spring.height;
      if (step.norm() > most) step *= most / step.norm();
      SurfacePoint to;
      if (!state.surface.project(mesh.position(v) + step, mesh.data(v).point, to)) continue;
      const Corner moved{to.xyz, state.surface.normal(to)};
      if (!stays_upright(mesh, v, moved)) continue;
      mesh.data(v).point = to;
      mesh.data(v).normal = moved.normal;
    }
  }
}

}  // namespace advlayers
