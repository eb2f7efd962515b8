#include "measure/bend_middle.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kLeastGain = 0.25;  // of the bend's 1 - cosine

}  // namespace

double bend_cosine(const SurfaceMesh& mesh, HalfedgeH h) {
  return mesh.data(mesh.from(h)).normal.dot(mesh.data(mesh.to(h)).normal);
}

// The foot of the top of a circular arc over the edge, as the foot of the chord's middle may lie
// back on either side of the bend; or that foot, where the surface twists about the edge.
bool find_bend_middle(const SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h,
                      VertexData& middle) {
  const VertexData &a = mesh.data(mesh.from(h)), &b = mesh.data(mesh.to(h));
  const Vec3 chord = b.point.xyz - a.point.xyz;
  const Vec3 outward = a.normal + b.normal;
  const double before = bend_cosine(mesh, h);
  const double turn = std::acos(std::clamp(before, -1.0, 1.0));
  // Where the surface bends inward between the ends, so does the arc.
  const double side = a.normal.dot(chord) < b.normal.dot(chord) ? 1.0 : -1.0;
  const double rise = side * 0.5 * chord.norm() * std::tan(0.25 * turn);
  const Vec3 half = a.point.xyz + 0.5 * chord;
  double best = before + kLeastGain * (1.0 - before);
  for (const Vec3& target : {Vec3(half + rise * outward.normalized()), half}) {
    for (const VertexData* seed : {&a, &b}) {
      VertexData found;
      if (!surface.project(target, seed->point, found.point)) continue;
      found.normal = surface.normal(found.point);
      const double after = std::min(found.normal.dot(a.normal), found.normal.dot(b.normal));
      if (after <= best) continue;
      best = after;
      middle.point = found.point;
      middle.normal = found.normal;
    }
  }
  return best > before + kLeastGain * (1.0 - before);
}

}  // namespace advlayers
