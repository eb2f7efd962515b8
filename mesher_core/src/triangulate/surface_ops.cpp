#include "triangulate/surface_ops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace advlayers {
namespace {

constexpr double kGain = 1e-4;        // of the score; less is no reason to change the mesh
constexpr double kLongestMade = 1.6;  // edge after a collapse, in wanted lengths
const double kEquilateralHeight = std::sqrt(3.0) / 2;  // over its side

}  // namespace

SurfaceOps::SurfaceOps(SurfaceMesh& mesh, std::vector<double>& sizes, PatchSurface& surface)
    : mesh_(mesh), sizes_(sizes), surface_(surface) {}

// A vertex that is fixed, but on no border, is a tip: the surface has no one normal there.
Corner SurfaceOps::corner_at(VertexH v) const {
  if (!movable(v) && !mesh_.is_border(v)) return {mesh_.position(v), Vec3::Zero()};
  return corner(mesh_, v);
}

double SurfaceOps::score(FaceH f) const {
  const HalfedgeH h = mesh_.halfedge(f);
  return triangle_score(corner_at(mesh_.from(h)), corner_at(mesh_.to(h)),
                        corner_at(mesh_.to(mesh_.next(h))));
}

double SurfaceOps::standing_about(VertexH v) const { return standing_with(v, corner_at(v)); }

// The standing of the triangles about v if it were at `moved`.
double SurfaceOps::standing_with(VertexH v, const Corner& moved) const {
  Standing standing;
  for (const HalfedgeH h : mesh_.around(v)) {
    if (!mesh_.is_border(h)) {
      standing.add(
          triangle_score(moved, corner_at(mesh_.to(h)), corner_at(mesh_.to(mesh_.next(h)))));
    }
  }
  return standing.value();
}

bool SurfaceOps::flip(HalfedgeH h) {
  if (mesh_.is_border(h) || mesh_.is_border(SurfaceMesh::twin(h))) return false;
  const Corner a = corner_at(mesh_.from(h)), b = corner_at(mesh_.to(h));
  const Corner c = corner_at(mesh_.to(mesh_.next(h)));
  const Corner d = corner_at(mesh_.to(mesh_.next(SurfaceMesh::twin(h))));
  Standing before, after;
  before.add(triangle_score(a, b, c));
  before.add(triangle_score(b, a, d));
  after.add(triangle_score(d, c, a));
  if (before.value() >= 0.0 && after.value() <= before.value() + kGain) return false;
  after.add(triangle_score(c, d, b));
  if (after.value() <= before.value() + kGain) return false;
  // Asked last: most edges are refused by what is cheaper to know.
  if (mesh_.flip_veto(h) != Veto::kNone) return false;
  mesh_.flip(h);
  return true;
}

bool SurfaceOps::place(VertexH v, const Vec3& target, SurfacePoint& foot, Corner& at) {
  if (!surface_.project(target, mesh_.data(v).point, foot)) return false;
  at = {foot.xyz, surface_.normal(foot)};
  return true;
}

bool SurfaceOps::move(VertexH v, const Vec3& target, double enough) {
  const VertexData& data = mesh_.data(v);
  const Vec3 step = target - data.point.xyz;
  SurfacePoint foot;
  Corner at;
  if (!place(v, target - step.dot(data.normal) * data.normal, foot, at)) return false;
  const double before = standing_about(v);
  if (standing_with(v, at) < std::min(before + kGain, enough)) return false;
  mesh_.data(v).point = foot;
  mesh_.data(v).normal = at.normal;
  return true;
}

Vec3 SurfaceOps::center_of_neighbours(VertexH v) const {
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (const HalfedgeH h : mesh_.around(v)) {
    sum += mesh_.position(mesh_.to(h));
    ++count;
  }
  return sum / count;
}

// Where v would make an equilateral triangle on a -> b.
Vec3 SurfaceOps::ideal_apex(VertexH a, VertexH b, VertexH v) const {
  const Vec3 &pa = mesh_.position(a), &pb = mesh_.position(b);
  return (pa + pb) / 2 + kEquilateralHeight * mesh_.data(v).normal.cross(pb - pa);
}

bool SurfaceOps::optimize(VertexH v) {
  if (!movable(v)) return false;
  const double before = standing_about(v);
  double worst = std::numeric_limits<double>::infinity();
  Vec3 mean_apex = Vec3::Zero(), worst_apex = Vec3::Zero();
  int count = 0;
  for (const HalfedgeH h : mesh_.around(v)) {
    const VertexH a = mesh_.to(h), b = mesh_.to(mesh_.next(h));
    const Vec3 apex = ideal_apex(a, b, v);
    const double s = triangle_score(corner_at(v), corner_at(a), corner_at(b));
    if (s < worst) {
      worst = s;
      worst_apex = apex;
    }
    mean_apex += apex;
    ++count;
  }
  const Vec3 here = mesh_.position(v);
  SurfacePoint best_foot, foot;
  Corner best_at, at;
  double best = before + kGain;
  bool found = false;
  for (const Vec3& target : {Vec3(mean_apex / count), center_of_neighbours(v), worst_apex}) {
    for (const double share : {1.0, 0.5, 0.2}) {
      if (!place(v, here + share * (target - here), foot, at)) continue;
      const double after = standing_with(v, at);
      if (after <= best) continue;
      best = after;
      best_foot = foot;
      best_at = at;
      found = true;
    }
  }
  if (!found) return false;
  mesh_.data(v).point = best_foot;
  mesh_.data(v).normal = best_at.normal;
  return true;
}

bool SurfaceOps::collapse(HalfedgeH h, double enough) {
  const VertexH v = mesh_.from(h), onto = mesh_.to(h);
  if (!movable(v) || mesh_.collapse_veto(h) != Veto::kNone) return false;
  const Corner moved = corner_at(onto);
  const double needed = std::min(standing_about(v) + kGain, enough);
  Standing after;
  for (const HalfedgeH o : mesh_.around(h)) {
    if (o == h) continue;
    const VertexH a = mesh_.to(o), b = mesh_.to(mesh_.next(o));
    const double wanted = (sizes_[a.index()] + sizes_[onto.index()]) / 2;
    if ((mesh_.position(a) - moved.xyz).norm() > kLongestMade * wanted) return false;
    if (a == onto || b == onto) continue;
    after.add(triangle_score(moved, corner_at(a), corner_at(b)));
    if (after.value() < needed) return false;
  }
  mesh_.collapse(h);
  return true;
}

bool SurfaceOps::split(HalfedgeH h, double enough) {
  if (mesh_.split_edge_veto(h) != Veto::kNone) return false;
  const VertexH a = mesh_.from(h), b = mesh_.to(h);
  const Vec3 middle = (mesh_.position(a) + mesh_.position(b)) / 2;
  VertexData data;
  if (!surface_.project(middle, mesh_.data(movable(a) ? a : b).point, data.point)) return false;
  data.normal = surface_.normal(data.point);
  const Corner at{data.point.xyz, data.normal}, ca = corner_at(a), cb = corner_at(b);
  Standing before, after;
  for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
    const Corner apex = corner_at(mesh_.to(mesh_.next(side)));
    const bool ahead = side == h;
    const Corner &from = ahead ? ca : cb, &to = ahead ? cb : ca;
    before.add(triangle_score(from, to, apex));
    after.add(triangle_score(from, at, apex));
    after.add(triangle_score(at, to, apex));
  }
  if (after.value() < std::min(before.value() + kGain, enough)) return false;
  const double wanted = wanted_length(h);
  const VertexH v = mesh_.split_edge(h, data);
  sizes_.resize(mesh_.vertex_capacity(), wanted);
  optimize(v);
  return true;
}

}  // namespace advlayers
