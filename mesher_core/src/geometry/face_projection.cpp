#include <ElSLib.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/face_surface.h"
#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

constexpr int kMaxIterations = 40;  // of Newton, with halved steps
// A Newton step shorter than this part of the face's size squares to nothing: it is the last one.
constexpr double kLastStep = 1e-8;
// Steps so short, against the distance, change it by less than its rounding.
constexpr double kNoise = 1e-7;

double nearest_period(double x, double near, double period) {
  return period > 0.0 ? x + period * std::round((near - x) / period) : x;
}

}  // namespace

bool FaceSurface::project(const Vec3& point, double& u, double& v, Vec3& foot) const {
  if (is_elementary()) {
    project_elementary(point, u, v, foot);
    return true;
  }
  const double u_seed = u, v_seed = v;
  if (newton(point, u, v, foot)) {
    cross_pole(point, u, v, foot);
    return true;
  }
  // A seed on a pole, or beyond a fold: start again from places around it.
  const double u_span = face_->u_max - face_->u_min, v_span = face_->v_max - face_->v_min;
  for (const double reach : {0.02, 0.1}) {
    for (int k = 0; k < 4; ++k) {
      double uk = u_seed + (k % 2 ? reach : -reach) * u_span;
      double vk = v_seed + (k / 2 ? reach : -reach) * v_span;
      Vec3 other;
      clamp(uk, vk);
      const bool reached = newton(point, uk, vk, other);
      if (!reached || (other - point).norm() > (foot - point).norm() + kLastStep * size_) continue;
      u = uk;
      v = vk;
      foot = other;
      return true;
    }
  }
  return false;
}

// At a pole every direction leads on, but Newton knows only the one it came by: the foot of a point
// beyond the pole is sought from around it.
void FaceSurface::cross_pole(const Vec3& point, double& u, double& v, Vec3& foot) const {
  if (u != u_lo_ && u != u_hi_ && v != v_lo_ && v != v_hi_) return;
  Vec3 xyz, du, dv;
  first(u, v, xyz, du, dv);
  const bool u_gone = u_collapsed(du), v_gone = v_collapsed(dv);
  if (u_gone == v_gone) return;
  const double distance = (point - foot).norm();
  constexpr int kAround = 16;  // directions that are tried about a pole
  double best = std::numeric_limits<double>::infinity(), u_best = u, v_best = v;
  for (int k = 0; k < kAround; ++k) {
    const double part = static_cast<double>(k) / kAround;
    double uk = u_gone ? face_->u_min + part * (face_->u_max - face_->u_min) : u;
    double vk = v_gone ? face_->v_min + part * (face_->v_max - face_->v_min) : v;
    const double reach = std::clamp(distance / size_, 1e-4, 0.1);
    step_inside(uk, vk, reach, v_gone, u_gone);
    const double d = (value(uk, vk) - point).norm();
    if (d >= best) continue;
    best = d;
    u_best = uk;
    v_best = vk;
  }
  Vec3 other;
  if (!newton(point, u_best, v_best, other) || (other - point).norm() >= distance) return;
  u = nearest_period(u_best, u, face_->u_period);
  v = nearest_period(v_best, v, face_->v_period);
  foot = other;
}

void FaceSurface::project_elementary(const Vec3& point, double& u, double& v, Vec3& foot) const {
  const double u_seed = u, v_seed = v;
  gp_Pnt p = to_pnt(point);
  if (located_) p.Transform(inverse_);
  switch (face_->kind) {
    case SurfaceKind::kPlane:
      ElSLib::PlaneParameters(axes_, p, u, v);
      break;
    case SurfaceKind::kCylinder:
      ElSLib::CylinderParameters(axes_, radius_, p, u, v);
      break;
    case SurfaceKind::kCone:
      ElSLib::ConeParameters(axes_, radius_, second_, p, u, v);
      break;
    case SurfaceKind::kSphere:
      ElSLib::SphereParameters(axes_, radius_, p, u, v);
      break;
    default:
      ElSLib::TorusParameters(axes_, radius_, second_, p, u, v);
  }
  if (face_->kind != SurfaceKind::kPlane) {
    // On the axis every direction is nearest: the seed's is kept.
    const gp_Vec from_axis = gp_Vec(axes_.Location(), p).Crossed(gp_Vec(axes_.Direction()));
    if (from_axis.Magnitude() * scale_ <= 1e-13 * size_) u = u_seed;
    u = nearest_period(u, u_seed, face_->u_period);
    v = nearest_period(v, v_seed, face_->v_period);
  }
  foot = value(u, v);
}

void FaceSurface::clamp(double& u, double& v) const {
  if (face_->u_period == 0.0) u = std::clamp(u, u_lo_, u_hi_);
  if (face_->v_period == 0.0) v = std::clamp(v, v_lo_, v_hi_);
}

// One step towards a stationary point of |S - P|^2 / 2, held inside the natural bounds: full
// Newton where the Hessian is safely positive, else Gauss-Newton. False: nothing to solve.
bool FaceSurface::newton_step(const Vec3& point, double u, double v, const SurfaceDerivatives& s,
                              double& du, double& dv) const {
  const Vec3 d = s.xyz - point;
  const double gu = d.dot(s.du), gv = d.dot(s.dv);
  const double a = s.du.squaredNorm(), b = s.du.dot(s.dv), c = s.dv.squaredNorm();
  const bool u_gone = u_collapsed(s.du), v_gone = v_collapsed(s.dv);
  double h11 = a + d.dot(s.duu), h12 = b + d.dot(s.duv), h22 = c + d.dot(s.dvv);
  const double floor = 1e-3;
  if (!(h11 > floor * a && h22 > floor * c && h11 * h22 - h12 * h12 > floor * (a * c - b * b))) {
    h11 = a;
    h12 = b;
    h22 = c;
  }
  const double det = h11 * h22 - h12 * h12;
  const bool solvable = det > 1e-14 * h11 * h22;
  if (u_gone && v_gone) return false;
  if (u_gone || v_gone || !solvable) {
    const bool along_u = v_gone || (!u_gone && gu * gu * h22 > gv * gv * h11);
    du = along_u ? -gu / h11 : 0.0;
    dv = along_u ? 0.0 : -gv / h22;
  } else {
    du = -(h22 * gu - h12 * gv) / det;
    dv = -(h11 * gv - h12 * gu) / det;
  }
  const auto blocked = [](double x, double step, double lo, double hi, double period) {
    return period == 0.0 && ((x <= lo && step < 0.0) || (x >= hi && step > 0.0));
  };
  const bool u_stuck = blocked(u, du, u_lo_, u_hi_, face_->u_period);
  if (u_stuck) {
    du = 0.0;
    dv = v_gone ? 0.0 : -gv / h22;
  }
  if (blocked(v, dv, v_lo_, v_hi_, face_->v_period)) {
    dv = 0.0;
    du = u_stuck || u_gone ? 0.0 : -gu / h11;
    if (blocked(u, du, u_lo_, u_hi_, face_->u_period)) du = 0.0;
  }
  const double reach_u = 0.3 * (face_->u_period > 0.0 ? face_->u_period : u_hi_ - u_lo_);
  const double reach_v = 0.3 * (face_->v_period > 0.0 ? face_->v_period : v_hi_ - v_lo_);
  const double shrink = std::max({1.0, std::abs(du) / reach_u, std::abs(dv) / reach_v});
  double u_new = u + du / shrink, v_new = v + dv / shrink;
  clamp(u_new, v_new);
  du = u_new - u;
  dv = v_new - v;
  return true;
}

bool FaceSurface::backtrack(const Vec3& point, double du, double dv, double& u, double& v,
                            SurfaceDerivatives& s, double& distance2) const {
  for (int half = 0; half < 12; ++half, du *= 0.5, dv *= 0.5) {
    const SurfaceDerivatives trial = second(u + du, v + dv);
    const double trial2 = (trial.xyz - point).squaredNorm();
    if (trial2 >= distance2) continue;
    u += du;
    v += dv;
    s = trial;
    distance2 = trial2;
    return true;
  }
  return false;
}

bool FaceSurface::newton(const Vec3& point, double& u, double& v, Vec3& foot) const {
  clamp(u, v);
  SurfaceDerivatives s = second(u, v);
  double distance2 = (s.xyz - point).squaredNorm();
  for (int i = 0; i < kMaxIterations; ++i) {
    double du = 0.0, dv = 0.0;
    if (!newton_step(point, u, v, s, du, dv)) break;
    const double length = (s.du * du + s.dv * dv).norm();
    if (length <= kLastStep * size_) {
      u += du;
      v += dv;
      foot = value(u, v);
      return true;
    }
    if (!backtrack(point, du, dv, u, v, s, distance2)) {
      // From afar the distance cannot tell steps of sqrt(epsilon) apart: Newton still can.
      const bool noise = length <= kNoise * (size_ + std::sqrt(distance2));
      if (noise) {
        u += du;
        v += dv;
        s.xyz = value(u, v);
      }
      break;
    }
  }
  foot = s.xyz;
  // No step helps: on a crease of the surface that is still the nearest point.
  return !descends(point, u, v, std::sqrt(distance2));
}

bool FaceSurface::descends(const Vec3& point, double u, double v, double distance) const {
  const double reach = 1e-6 * size_;
  for (int k = 0; k < 8; ++k) {
    const double angle = 0.25 * M_PI * k;
    double uk = u + (speed_u_ > 0.0 ? std::cos(angle) * reach / speed_u_ : 0.0);
    double vk = v + (speed_v_ > 0.0 ? std::sin(angle) * reach / speed_v_ : 0.0);
    clamp(uk, vk);
    if ((value(uk, vk) - point).norm() < distance - 1e-3 * reach) return true;
  }
  return false;
}

}  // namespace advlayers
