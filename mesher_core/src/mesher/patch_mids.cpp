#include "mesher/patch_mids.h"

#include <algorithm>
#include <limits>

namespace advlayers {
namespace {

// Part of the straight element's Jacobian below which a curved element is drawn back.
constexpr double kLeastJacobian = 0.1;
// An easing that gains less than this part of it helps nobody.
constexpr double kGain = 1e-6;

}  // namespace

PatchMids::PatchMids(const PatchJob& job, const Model& model, const Settings& settings,
                     const BoundaryMids& boundary)
    : job_(job),
      mesh_(job.mesh()),
      boundary_(boundary),
      evaluator_(model),
      surface_(evaluator_, job.faces(), feature_rule(settings)) {}

Vec3 PatchMids::at(HalfedgeH h) const {
  const Mid& mid = mids_[h.index() >> 1];
  return mid.shared >= 0 ? boundary_[mid.shared].at() : mid.at;
}

Vec3 PatchMids::chord(HalfedgeH h) const {
  return 0.5 * (mesh_.position(mesh_.from(h)) + mesh_.position(mesh_.to(h)));
}

// A unit vector in the surface, at right angles to the edge.
Vec3 PatchMids::leftwards(HalfedgeH h) const {
  const VertexData& from = mesh_.data(mesh_.from(h));
  const VertexData& to = mesh_.data(mesh_.to(h));
  return (from.normal + to.normal).cross(to.point.xyz - from.point.xyz).normalized();
}

// From the ends of the edge; inner vertices have the better parameters: at a pole, one is free.
bool PatchMids::foot(const Vec3& xyz, HalfedgeH h, SurfacePoint& found) const {
  const double reach = (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  VertexH seeds[] = {mesh_.from(h), mesh_.to(h)};
  if (mesh_.data(seeds[0]).support != Support::kPatch) std::swap(seeds[0], seeds[1]);
  for (const VertexH seed : seeds) {
    if (surface_.project(xyz, mesh_.data(seed).point, found) && (found.xyz - xyz).norm() < reach) {
      return true;
    }
  }
  return false;
}

// With that share of its sagitta; on the chord where no foot is found.
Vec3 PatchMids::on_cad(HalfedgeH h, double share) const {
  const HalfedgeH even(h.value & ~1);
  const Vec3 middle = chord(even);
  if (mesh_.curve(even).valid() && !mesh_.is_border(even) && !mesh_.is_border(mesh_.twin(even))) {
    const FaceId left = job_.face_of(mesh_.face(even));
    const FaceId right = job_.face_of(mesh_.face(mesh_.twin(even)));
    PatchSurface::InnerPoint inner;
    if (left != right && surface_.nearest_between(left, right, middle, inner) && !inner.at_end) {
      return inner.point.xyz;
    }
  }
  const double sagitta = mids_[even.index() >> 1].sagitta * share;
  SurfacePoint found;
  const Vec3 sought = sagitta == 0.0 ? middle : Vec3(middle + sagitta * leftwards(even));
  return foot(sought, even, found) ? found.xyz : middle;
}

Vec3 PatchMids::placed(HalfedgeH h, int eased) const {
  if (eased <= kEasings) return on_cad(h, 1.0 - eased / double(kEasings));
  const Vec3 on = on_cad(h, 0.0);
  return on + ((eased - kEasings) / double(kEasings)) * (chord(h) - on);
}

// The bend of a border edge goes up its column of layer cells, in proportion to the edges there:
// fronts are parallel curves.
void PatchMids::bend_layers() {
  std::vector<double> sum(mids_.size(), 0.0);
  std::vector<int> count(mids_.size(), 0);
  for (std::size_t i = 0; i < mesh_.halfedge_capacity(); ++i) {
    HalfedgeH h(i);
    if (!mesh_.alive(h) || mesh_.is_border(h) || shared(h) < 0) continue;
    SurfacePoint flat;
    if (!foot(chord(h), h, flat)) continue;
    const double length = (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
    const double bend = (boundary_[shared(h)].curve - flat.xyz).dot(leftwards(h)) / length;
    int layer = 0;
    while (!mesh_.is_border(h) && mesh_.degree(mesh_.face(h)) == 4 &&
           mesh_.data(mesh_.face(h)).layer > layer) {
      layer = mesh_.data(mesh_.face(h)).layer;
      h = SurfaceMesh::twin(mesh_.next(mesh_.next(h)));
      sum[h.index() >> 1] += h.value % 2 == 0 ? bend : -bend;
      ++count[h.index() >> 1];
    }
  }
  for (std::size_t e = 0; e < mids_.size(); ++e) {
    if (count[e] == 0 || mids_[e].shared >= 0) continue;
    const HalfedgeH h(2 * e);
    const double length = (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
    mids_[e].sagitta = length * sum[e] / count[e];
  }
}

void PatchMids::place(const RunContext& context) {
  mids_.assign(mesh_.halfedge_capacity() / 2, {});
  for (std::size_t e = 0; e < mids_.size(); ++e) {
    const HalfedgeH h(2 * e);
    if (!mesh_.alive(h) || !mesh_.curve(h).valid()) continue;
    if (!mesh_.is_border(h) && !mesh_.is_border(SurfaceMesh::twin(h))) continue;
    const NodeId from = mesh_.data(mesh_.from(h)).node, to = mesh_.data(mesh_.to(h)).node;
    mids_[e].shared = boundary_.find(mesh_.curve(h), from, to);
  }
  bend_layers();
  for (std::size_t e = 0; e < mids_.size(); ++e) {
    context.check();
    const HalfedgeH h(2 * e);
    if (!mesh_.alive(h) || mids_[e].shared >= 0) continue;
    mids_[e].at = placed(h, 0);
  }
}

CurvedElement PatchMids::element(FaceH face) const {
  CurvedElement found;
  for (const HalfedgeH h : mesh_.sides(face)) {
    const auto k = static_cast<std::size_t>(found.count++);
    found.corners[k] = mesh_.position(mesh_.from(h));
    found.mids[k] = at(h);
  }
  return found;
}

bool PatchMids::overbent(FaceH face) const {
  return least_jacobian(element(face)) < kLeastJacobian;
}

std::vector<FaceH> PatchMids::overbent(const RunContext& context) const {
  std::vector<FaceH> found;
  for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
    context.check();
    if (mesh_.alive(FaceH(i)) && overbent(FaceH(i))) found.emplace_back(i);
  }
  return found;
}

void PatchMids::ease(HalfedgeH h) {
  Mid& mid = mids_[h.index() >> 1];
  mid.eased = static_cast<std::uint8_t>(next_step(mid));
  mid.at = placed(h, mid.eased);
}

HalfedgeH PatchMids::best_to_ease(FaceH face) const {
  CurvedElement tried = element(face);
  const double now = least_jacobian(tried);
  HalfedgeH best, best_on_cad;
  double most = -std::numeric_limits<double>::infinity(), most_on_cad = now + kGain;
  std::size_t side = 0;
  for (const HalfedgeH h : mesh_.sides(face)) {
    const std::size_t k = side++;
    const Mid& mid = mids_[h.index() >> 1];
    const bool border = mid.shared >= 0;
    if (border ? boundary_[mid.shared].eased == BoundaryMid::kEasings : mid.eased == 2 * kEasings) {
      continue;
    }
    const Vec3 before = tried.mids[k];
    if (border) {
      BoundaryMid moved = boundary_[mid.shared];
      ++moved.eased;
      tried.mids[k] = moved.at();
    } else {
      tried.mids[k] = placed(h, next_step(mid));
    }
    const double gained = least_jacobian(tried);
    tried.mids[k] = before;
    if (gained > most) {
      most = gained;
      best = h;
    }
    if (!border && next_step(mid) <= kEasings && gained > most_on_cad) {
      most_on_cad = gained;
      best_on_cad = h;
    }
  }
  return best_on_cad.valid() ? best_on_cad : best;
}

double PatchMids::off_cad(HalfedgeH h) const {
  const Mid& mid = mids_[h.index() >> 1];
  if (mid.shared >= 0) return (boundary_[mid.shared].at() - boundary_[mid.shared].curve).norm();
  return mid.eased > kEasings ? (mid.at - on_cad(h, 0.0)).norm() : 0.0;
}

}  // namespace advlayers
