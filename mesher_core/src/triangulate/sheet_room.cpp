#include "triangulate/sheet_room.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/predicates.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

// No point nearer to another than this share of the size wanted there.
constexpr double kClosest = 0.65;
constexpr double kClosestToBorder = 0.4;
constexpr double kBorderShare = 0.6;  // of the border edge's length, squared
constexpr int kWalkLimit = 200;       // triangles that a walk visits

}  // namespace

int walk_to(const PlanarTriangulation& mesh, int t, const Vec2& p) {
  int from = -1;
  for (int step = 0; step < kWalkLimit; ++step) {
    int next = -1;
    bool outside = false;
    for (int i = 0; i < 3; ++i) {
      const Side s{t, i};
      if (mesh.triangle(t).n[i] == from && from >= 0) continue;
      if (orient2d(mesh.point(mesh.from(s)), mesh.point(mesh.to(s)), p) >= 0) continue;
      outside = true;
      if (mesh.segment(s) < 0) next = mesh.triangle(t).n[i];
    }
    if (!outside) return t;
    if (next < 0) return -1;
    from = t;
    t = next;
  }
  return -1;
}

bool crowds(LiftedTriangulation& sheet, int t, const Vec2& p, double own_size) {
  const PlanarTriangulation& mesh = sheet.mesh();
  const Metric metric = sheet.evaluate(p).metric;
  const auto& v = mesh.triangle(t).v;
  double size = own_size;
  std::array<double, 3> distance{};
  for (int i = 0; i < 3; ++i) {
    const LiftedVertex& corner = sheet.vertex(v[i]);
    const Vec2 d = p - mesh.point(v[i]);
    distance[i] = std::sqrt((corner.metric + metric).squared(d) / 2);
    size = std::min(size, corner.size + sheet.gradation() * distance[i]);
  }
  if (*std::min_element(distance.begin(), distance.end()) < kClosest * size) return true;
  for (int i = 0; i < 3; ++i) {
    const Side s{t, i};
    if (mesh.segment(s) < 0) continue;
    const Vec2 d = mesh.point(mesh.to(s)) - mesh.point(mesh.from(s));
    const Vec2 w = p - mesh.point(mesh.from(s));
    const double length2 = metric.squared(d);
    const double cross = d.x() * w.y() - d.y() * w.x();
    const double height2 = cross * cross * metric.determinant() / length2;
    if (height2 <
        kClosestToBorder * kClosestToBorder * std::max(size * size, kBorderShare * length2)) {
      return true;
    }
  }
  return false;
}

}  // namespace advlayers
