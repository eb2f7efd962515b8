#include "measure/element_measures.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/ties.h"

namespace advlayers {
namespace {

// Cosine of the furthest that a quad may lean from the surface at one of its corners.
constexpr double kLeastLean = 0.25;
// Squared sine of the least angle by which a corner stays below 180 degrees as the surface sees it:
// along a bent border three nodes in a row make a corner in space that is none on the surface.
constexpr double kLeastTurn = 1e-3;

}  // namespace

ElementCorners corners_of(const SurfaceMesh& mesh, FaceH face) {
  ElementCorners element;
  for (const HalfedgeH h : mesh.sides(face)) {
    element.at[static_cast<std::size_t>(element.count++)] = mesh.position(mesh.from(h));
  }
  return element;
}

Vec3 area_vector(const ElementCorners& element) {
  const auto& x = element.at;
  if (element.count == 4) return 0.5 * (x[2] - x[0]).cross(x[3] - x[1]);
  return 0.5 * (x[1] - x[0]).cross(x[2] - x[0]);
}

Vec3 centroid(const ElementCorners& element) {
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < element.count; ++k) sum += element.at[static_cast<std::size_t>(k)];
  return sum / element.count;
}

std::array<double, 4> interior_angles(const ElementCorners& element) {
  const Vec3 normal = area_vector(element);
  std::array<double, 4> angles{};
  for (int k = 0; k < element.count; ++k) {
    const Vec3& at = element.at[static_cast<std::size_t>(k)];
    const Vec3 ahead = element.next(k) - at;
    const Vec3 behind = element.prev(k) - at;
    const Vec3 turn = ahead.cross(behind);
    const double angle = std::atan2(turn.norm(), ahead.dot(behind)) / kDegree;
    angles[static_cast<std::size_t>(k)] = turn.dot(normal) < 0.0 ? 360.0 - angle : angle;
  }
  return angles;
}

double right_angle_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                           const Vec3& normal) {
  const std::array<Vec3, 4> side{b - a, c - b, d - c, a - d};
  std::array<double, 4> squared{};
  for (std::size_t k = 0; k < 4; ++k) squared[k] = side[k].squaredNorm();
  double worst = 0.0;  // cos^2
  bool folded = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& behind = side[(k + 3) & 3];
    folded = folded || behind.cross(side[k]).dot(normal) <= 0.0;
    const double dot = behind.dot(side[k]);
    const double lengths = squared[k] * squared[(k + 3) & 3];
    worst = lengths > 0.0 ? std::max(worst, dot * dot / lengths) : 1.0;
  }
  const double cosine = std::sqrt(worst);
  return settled(folded ? -1.0 - cosine : 1.0 - cosine);
}

double quad_quality(const SurfaceMesh& mesh, VertexH a, VertexH b, VertexH c, VertexH d) {
  const Vec3 &pa = mesh.position(a), &pb = mesh.position(b);
  const Vec3 &pc = mesh.position(c), &pd = mesh.position(d);
  const Vec3 area = (pc - pa).cross(pd - pb);
  const double least = kLeastLean * area.norm();
  const std::array<VertexH, 4> corner{a, b, c, d};
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3& normal = mesh.data(corner[k]).normal;
    if (normal.dot(area) <= least) return -1.0;
    const Vec3 ahead = mesh.position(corner[(k + 1) & 3]) - mesh.position(corner[k]);
    const Vec3 behind = mesh.position(corner[(k + 3) & 3]) - mesh.position(corner[k]);
    const double turn = ahead.cross(behind).dot(normal);
    if (turn <= 0.0 || turn * turn < kLeastTurn * ahead.squaredNorm() * behind.squaredNorm()) {
      return -1.0;
    }
  }
  return right_angle_quality(pa, pb, pc, pd, area);
}

double min_angle_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) {
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const Vec3 turn = ab.cross(-ca);
  const double la = ab.squaredNorm(), lb = bc.squaredNorm(), lc = ca.squaredNorm();
  // The smallest angle lies between the two longest sides.
  const double product = la * lb * lc / std::max(std::min({la, lb, lc}), 1e-300);
  const double sine = product > 0.0 ? turn.norm() / std::sqrt(product) : 0.0;
  return settled(turn.dot(normal) > 0.0 ? sine : -sine);
}

}  // namespace advlayers
