#include "quality/core_splits.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "quality/core_region.h"
#include "quality/element_measures.h"

namespace advlayers {
namespace {

constexpr double kBentCosine = 0.7660444431;  // of 40 degrees
// A bend sharper than the surface's own kinks would be split for ever.
constexpr int kMostHalvings = 5;
// A triangle that a split makes may not be worse than this, nor than the one it replaces.
constexpr double kLeastSine = 0.17;
constexpr double kLeastGain = 0.25;  // of the bend's 1 - cosine

double bend_cosine(const SurfaceMesh& mesh, HalfedgeH h) {
  return mesh.data(mesh.from(h)).normal.dot(mesh.data(mesh.to(h)).normal);
}

// The sine of the smallest angle against the three normals' mean.
double shape_of(const VertexData& a, const VertexData& b, const VertexData& c) {
  return min_angle_sine(a.point.xyz, b.point.xyz, c.point.xyz, a.normal + b.normal + c.normal);
}

bool split_helps(const SurfaceMesh& mesh, HalfedgeH h, const VertexData& middle) {
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    const VertexData& a = mesh.data(mesh.from(side));
    const VertexData& b = mesh.data(mesh.to(side));
    const VertexData& c = mesh.data(mesh.to(mesh.next(side)));
    const double least = std::min(kLeastSine, shape_of(a, b, c));
    if (shape_of(a, middle, c) < least || shape_of(middle, b, c) < least) return false;
  }
  return true;
}

// The point half-way around the bend from one end to the other: the foot of the top of a circular
// arc over the edge, as the foot of the chord's middle may lie back on either side of the bend; or
// that foot, where the surface twists about the edge.
bool find_middle(const SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h, VertexData& middle) {
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

}  // namespace

int split_bent_edges(SurfaceMesh& mesh, PatchSurface& surface, const CancelFlag& cancel) {
  struct Bent {
    HalfedgeH edge;
    int halvings;
  };
  std::vector<Bent> waiting;
  const auto enlist = [&](HalfedgeH h, int halvings) {
    if (halvings > kMostHalvings || !is_core_edge(mesh, h)) return;
    if (bend_cosine(mesh, h) < kBentCosine) waiting.push_back({h, halvings});
  };
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) enlist(HalfedgeH(i), 0);
  int splits = 0;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    cancel.check();
    const auto [h, halvings] = waiting[i];
    if (mesh.split_edge_veto(h) != Veto::kNone) continue;
    VertexData middle;
    if (!find_middle(mesh, surface, h, middle)) continue;
    if (!split_helps(mesh, h, middle)) continue;
    const VertexH v = mesh.split_edge(h, middle);
    ++splits;
    const HalfedgeH first = mesh.outgoing(v);
    HalfedgeH spoke = first;
    do {
      enlist(spoke, halvings + 1);
      spoke = mesh.rotate_cw(spoke);
    } while (spoke != first);
  }
  return splits;
}

}  // namespace advlayers
