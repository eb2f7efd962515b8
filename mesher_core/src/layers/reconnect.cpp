#include "layers/reconnect.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/ties.h"
#include "mesh/triangle_measures.h"

namespace advlayers {
namespace {

// The tangent of the smallest angle must gain this at a swap, or equal diagonals would swap for
// ever.
constexpr double kSwapGain = 1e-6;

struct SwapCorners {
  Corner a, b, c, d;  // h runs from a to b; c lies left of it, d right
};
SwapCorners swap_corners(const SurfaceMesh& mesh, HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  return {corner(mesh, mesh.from(h)), corner(mesh, mesh.to(h)), corner(mesh, mesh.to(mesh.next(h))),
          corner(mesh, mesh.to(mesh.next(t)))};
}

// The best collapse of v that is found, and its worth.
struct Collapse {
  HalfedgeH halfedge;
  double tangent = -1.0;  // of the least angle that it leaves
};

double dihedral_cosine(const Vec3& m, const Vec3& n) {
  const double scale = m.norm() * n.norm();
  return scale > 0.0 ? m.dot(n) / scale : 1.0;
}

// The triangles about v after v -> w, tested one by one against `limits`.
Veto collapse_quality(const SurfaceMesh& mesh, HalfedgeH h, Removal removal,
                      const ReconnectLimits& limits, double& least_tangent) {
  const VertexH v = mesh.from(h);
  const Corner w = corner(mesh, mesh.to(h));
  const Corner old = corner(mesh, v);
  double allowed = std::cos(limits.deviation * kDegree);
  double allowed_at_corner = std::cos(limits.at_corner * kDegree), at_corner = 1.0;
  double allowed_turn = std::cos(limits.edge_turn * kDegree), turn = 1.0;
  double least = INFINITY, largest = 0.0, deviation = 1.0, fold = 1.0;
  least_tangent = INFINITY;
  Vec3 last = Vec3::Zero();
  for (const HalfedgeH o : mesh.around_ccw(h)) {
    if (o == h) continue;
    const Corner p = corner(mesh, mesh.to(o));
    const Corner q = corner(mesh, mesh.to(mesh.next(o)));
    allowed = std::min(allowed, deviation_cosine(old, p, q));
    allowed_turn = std::min(allowed_turn, old.normal.dot(p.normal));
    allowed_at_corner = std::min(allowed_at_corner, corner_cosine(old, p, q));
    if (mesh.to(mesh.next(o)) == mesh.to(h)) break;
    least_tangent = std::min(least_tangent, settled(min_angle_tangent(w, p, q)));
    if (least_tangent <= 0.0) return Veto::kInverts;
    const double area2 = signed_area2(w, p, q);
    least = std::min(least, area2);
    largest = std::max(largest, area2);
    deviation = std::min(deviation, deviation_cosine(w, p, q));
    at_corner = std::min(at_corner, corner_cosine(w, p, q));
    turn = std::min(turn, w.normal.dot(p.normal));
    const Vec3 normal = (p.xyz - w.xyz).cross(q.xyz - w.xyz);
    if (last != Vec3::Zero()) fold = std::min(fold, dihedral_cosine(last, normal));
    last = normal;
  }
  if (at_corner < allowed_at_corner - 1e-12) return Veto::kLeavesSurface;
  if (turn < allowed_turn - 1e-12) return Veto::kLeavesSurface;
  if (removal == Removal::kForced) return Veto::kNone;
  if (largest > limits.area_ratio * least) return Veto::kAreaRatio;
  if (deviation < allowed - 1e-12) return Veto::kLeavesSurface;
  if (fold < std::cos(limits.dihedral * kDegree)) return Veto::kTooSharp;
  return Veto::kNone;
}

Collapse best_collapse(const SurfaceMesh& mesh, VertexH v, Removal removal,
                       const ReconnectLimits& limits, VetoTally& tally) {
  Collapse best;
  for (const HalfedgeH h : mesh.around(v)) {
    double tangent = 0.0;
    Veto veto = mesh.collapse_veto(h);
    if (veto == Veto::kNone) veto = collapse_quality(mesh, h, removal, limits, tangent);
    count(tally, veto);
    if (veto == Veto::kNone && tangent > best.tangent) best = {h, tangent};
  }
  return best;
}

// Swaps one edge away from v; false if none can be.
bool lower_valence(SurfaceMesh& mesh, VertexH v, VetoTally& tally) {
  for (const HalfedgeH h : mesh.around(v)) {
    const Veto veto = orientation_veto(mesh, h);
    count(tally, veto);
    if (veto == Veto::kNone) {
      mesh.flip(h);
      return true;
    }
  }
  return false;
}

}  // namespace

Veto orientation_veto(const SurfaceMesh& mesh, HalfedgeH h) {
  const Veto veto = mesh.flip_veto(h);
  if (veto != Veto::kNone) return veto;
  const auto [a, b, c, d] = swap_corners(mesh, h);
  const double flat = 1e-14 * (c.xyz - d.xyz).squaredNorm();
  if (signed_area2(d, c, a) <= flat || signed_area2(c, d, b) <= flat) return Veto::kInverts;
  return Veto::kNone;
}

Veto quality_veto(const SurfaceMesh& mesh, HalfedgeH h, const ReconnectLimits& limits) {
  const Veto veto = mesh.flip_veto(h);
  if (veto != Veto::kNone) return veto;
  const auto [a, b, c, d] = swap_corners(mesh, h);
  const double needed =
      std::min(min_angle_tangent(a, b, c), min_angle_tangent(b, a, d)) + kSwapGain;
  for (const double after : {min_angle_tangent(d, c, a), min_angle_tangent(c, d, b)}) {
    if (after <= 0.0) return Veto::kInverts;
    if (after <= needed) return Veto::kLowersQuality;
  }
  const double worst = std::min(deviation_cosine(a, b, c), deviation_cosine(b, a, d));
  const double made = std::min(deviation_cosine(d, c, a), deviation_cosine(c, d, b));
  if (made < std::min(worst, std::cos(limits.deviation * kDegree))) return Veto::kLeavesSurface;
  const double worst_corner = std::min(corner_cosine(a, b, c), corner_cosine(b, a, d));
  const double made_corner = std::min(corner_cosine(d, c, a), corner_cosine(c, d, b));
  if (made_corner < std::min(worst_corner, std::cos(limits.at_corner * kDegree))) {
    return Veto::kLeavesSurface;
  }
  return Veto::kNone;
}

bool remove_core_vertex(SurfaceMesh& mesh, VertexH v, Removal removal,
                        const ReconnectLimits& limits, VetoTally& tally) {
  for (int tries = mesh.valence(v); tries >= 3; --tries) {
    const Collapse best = best_collapse(mesh, v, removal, limits, tally);
    if (best.halfedge.valid()) {
      mesh.collapse(best.halfedge);
      return true;
    }
    if (removal == Removal::kGuarded || !lower_valence(mesh, v, tally)) return false;
  }
  return false;
}

SwapQueue::SwapQueue(SurfaceMesh& mesh) : mesh_(&mesh) { mesh.add_observer(this); }
SwapQueue::~SwapQueue() { mesh_->remove_observer(this); }

void SwapQueue::face_created(const SurfaceMesh&, FaceH f) { faces_.push_back(f); }
void SwapQueue::face_changed(const SurfaceMesh&, FaceH f) { faces_.push_back(f); }

void SwapQueue::run(const ReconnectLimits& limits, VetoTally& tally) {
  // Each swap raises the minimum angle of its pair, so this ends; the bound only guards round-off.
  std::size_t budget = 40 * (faces_.size() + 16);
  while (!faces_.empty() && budget-- > 0) {
    const FaceH f = faces_.back();
    faces_.pop_back();
    if (!mesh_->alive(f) || mesh_->data(f).layer > 0) continue;
    for (const HalfedgeH h : mesh_->sides(f)) {
      const Veto veto = quality_veto(*mesh_, h, limits);
      count(tally, veto);
      if (veto != Veto::kNone) continue;
      mesh_->flip(h);  // queues both faces again
      break;
    }
  }
  faces_.clear();
}

}  // namespace advlayers
