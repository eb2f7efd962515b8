#include "geometry/face_surface.h"

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

constexpr int kMaxIterations = 40;
// Below this part of the typical |Su| a direction is rounding noise: the surface is collapsed
// there.
constexpr double kCollapsed = 1e-8;
// Sine below which the direction of the derivatives' cross product is round-off: parameter lines
// that touch along an edge of the face are no rarity in lofted surfaces.
constexpr double kParallel = 1e-6;
// Below this part the parameter plane is too stretched to steer in.
constexpr double kRegular = 1e-3;
// A Newton step shorter than this part of the face's size squares to nothing: it is the last one.
constexpr double kLastStep = 1e-8;
constexpr double kNoise = 1e-7;

double nearest_period(double x, double near, double period) {
  return period > 0.0 ? x + period * std::round((near - x) / period) : x;
}

}  // namespace

GeomAdaptor_Surface basis_surface(const TopoDS_Face& face, gp_Trsf& location, bool& located) {
  TopLoc_Location where;
  Handle(Geom_Surface) surface = BRep_Tool::Surface(face, where);
  if (surface.IsNull()) throw GeometryError("it has no surface");
  while (surface->IsKind(STANDARD_TYPE(Geom_RectangularTrimmedSurface))) {
    surface = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)->BasisSurface();
  }
  located = !where.IsIdentity();
  if (located) location = where.Transformation();
  return GeomAdaptor_Surface(surface);
}

FaceSurface::FaceSurface(const TopoDS_Face& shape, const Face& face)
    : face_(&face), surface_(basis_surface(shape, location_, located_)) {
  if (located_) {
    inverse_ = location_.Inverted();
    scale_ = std::abs(location_.ScaleFactor());
  }
  // Some trimming curves leave a B-spline's knots a little: the face goes on there, extrapolated.
  const bool u_closed = face.u_period > 0.0, v_closed = face.v_period > 0.0;
  u_lo_ = u_closed ? surface_.FirstUParameter() : std::min(surface_.FirstUParameter(), face.u_min);
  u_hi_ = u_closed ? surface_.LastUParameter() : std::max(surface_.LastUParameter(), face.u_max);
  v_lo_ = v_closed ? surface_.FirstVParameter() : std::min(surface_.FirstVParameter(), face.v_min);
  v_hi_ = v_closed ? surface_.LastVParameter() : std::max(surface_.LastVParameter(), face.v_max);
  const double u_span = face.u_max - face.u_min, v_span = face.v_max - face.v_min;
  for (const double a : {0.1, 0.5, 0.9}) {
    for (const double b : {0.1, 0.5, 0.9}) {
      Vec3 xyz, du, dv;
      first(face.u_min + a * u_span, face.v_min + b * v_span, xyz, du, dv);
      speed_u_ = std::max(speed_u_, du.norm());
      speed_v_ = std::max(speed_v_, dv.norm());
    }
  }
  size_ = std::hypot(speed_u_ * u_span, speed_v_ * v_span);
}

// OpenCASCADE evaluates a closed surface that is not flagged periodic inside its range only.
void FaceSurface::wrap(double& u, double& v) const {
  if (is_elementary()) return;
  if (face_->u_period > 0.0 && (u < u_lo_ || u > u_hi_)) {
    u -= face_->u_period * std::floor((u - u_lo_) / face_->u_period);
  }
  if (face_->v_period > 0.0 && (v < v_lo_ || v > v_hi_)) {
    v -= face_->v_period * std::floor((v - v_lo_) / face_->v_period);
  }
}

Vec3 FaceSurface::value(double u, double v) const {
  wrap(u, v);
  gp_Pnt p;
  surface_.D0(u, v, p);
  if (located_) p.Transform(location_);
  return to_vec(p);
}

void FaceSurface::first(double u, double v, Vec3& xyz, Vec3& du, Vec3& dv) const {
  wrap(u, v);
  gp_Pnt p;
  gp_Vec pu, pv;
  surface_.D1(u, v, p, pu, pv);
  if (located_) {
    p.Transform(location_);
    pu.Transform(location_);
    pv.Transform(location_);
  }
  xyz = to_vec(p);
  du = to_vec(pu);
  dv = to_vec(pv);
}

SurfaceDerivatives FaceSurface::second(double u, double v) const {
  wrap(u, v);
  gp_Pnt p;
  gp_Vec pu, pv, puu, pvv, puv;
  surface_.D2(u, v, p, pu, pv, puu, pvv, puv);
  if (located_) {
    p.Transform(location_);
    for (gp_Vec* d : {&pu, &pv, &puu, &pvv, &puv}) d->Transform(location_);
  }
  return {to_vec(p), to_vec(pu), to_vec(pv), to_vec(puu), to_vec(pvv), to_vec(puv)};
}

bool FaceSurface::spans_plane(const Vec3& du, const Vec3& dv) const {
  const double a = du.norm(), b = dv.norm();
  return a > kCollapsed * speed_u_ && b > kCollapsed * speed_v_ &&
         du.cross(dv).norm() > kParallel * a * b;
}

bool FaceSurface::regular(const Vec3& du, const Vec3& dv) const {
  const double a = du.norm(), b = dv.norm();
  return a > kRegular * speed_u_ && b > kRegular * speed_v_ &&
         du.cross(dv).norm() > kRegular * a * b;
}

bool FaceSurface::in_bounds(double u, double v) const {
  const auto within = [](double x, double lo, double hi, double period) {
    const double slack = 1e-9 * (hi - lo);
    return period > 0.0 || (x >= lo - slack && x <= hi + slack);
  };
  return within(u, u_lo_, u_hi_, face_->u_period) && within(v, v_lo_, v_hi_, face_->v_period);
}

void FaceSurface::step_inside(double& u, double& v, double fraction, bool along_u,
                              bool along_v) const {
  const double u_mid = 0.5 * (face_->u_min + face_->u_max);
  const double v_mid = 0.5 * (face_->v_min + face_->v_max);
  if (along_u) u += fraction * (face_->u_max - face_->u_min) * (u < u_mid ? 1.0 : -1.0);
  if (along_v) v += fraction * (face_->v_max - face_->v_min) * (v < v_mid ? 1.0 : -1.0);
}

SurfaceFrame FaceSurface::frame(double u, double v) const {
  SurfaceFrame f;
  first(u, v, f.xyz, f.du, f.dv);
  const double sign = face_->reversed ? -1.0 : 1.0;
  if (spans_plane(f.du, f.dv)) {
    f.normal = sign * f.du.cross(f.dv).normalized();
    return f;
  }
  f.degenerate = true;
  f.normal = Vec3::Zero();
  // Su = 0 along a line v = const: the way inside leads along v; and the other way round.
  const bool u_gone = f.du.norm() <= kCollapsed * speed_u_;
  const bool v_gone = f.dv.norm() <= kCollapsed * speed_v_;
  const bool both = u_gone == v_gone;
  for (double fraction = 1e-5; fraction < 0.2; fraction *= 10.0) {
    Vec3 normals[2], xyz, du, dv;
    bool good = true;
    for (int k = 0; k < 2; ++k) {
      double uk = u, vk = v;
      step_inside(uk, vk, (k + 1) * fraction, v_gone || both, u_gone || both);
      first(uk, vk, xyz, du, dv);
      good = good && spans_plane(du, dv);
      normals[k] = du.cross(dv).normalized();
    }
    if (!good) continue;
    f.normal = sign * (2.0 * normals[0] - normals[1]).normalized();  // extrapolated to the point
    return f;
  }
  return f;
}

double FaceSurface::max_curvature(double u, double v) const {
  SurfaceDerivatives s = second(u, v);
  for (double fraction = 1e-4; !spans_plane(s.du, s.dv) && fraction < 0.2; fraction *= 10.0) {
    step_inside(u, v, fraction, true, true);
    s = second(u, v);
  }
  const Vec3 cross = s.du.cross(s.dv);
  const double area2 = cross.squaredNorm();
  if (!(area2 > 0.0)) return 0.0;
  const Vec3 n = cross / std::sqrt(area2);
  const double e = s.du.dot(s.du), f = s.du.dot(s.dv), g = s.dv.dot(s.dv);
  const double l = s.duu.dot(n), m = s.duv.dot(n), k = s.dvv.dot(n);
  const double mean = 0.5 * (e * k - 2.0 * f * m + g * l) / area2;
  const double gauss = (l * k - m * m) / area2;
  return std::abs(mean) + std::sqrt(std::max(0.0, mean * mean - gauss));
}

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
  const bool u_gone = du.norm() <= kCollapsed * speed_u_,
             v_gone = dv.norm() <= kCollapsed * speed_v_;
  if (u_gone == v_gone) return;
  const double distance = (point - foot).norm();
  constexpr int kAround = 16;
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
  gp_Ax3 axes;
  switch (face_->kind) {
    case SurfaceKind::kPlane:
      ElSLib::Parameters(surface_.Plane(), p, u, v);
      break;
    case SurfaceKind::kCylinder:
      axes = surface_.Cylinder().Position();
      ElSLib::Parameters(surface_.Cylinder(), p, u, v);
      break;
    case SurfaceKind::kCone:
      axes = surface_.Cone().Position();
      ElSLib::Parameters(surface_.Cone(), p, u, v);
      break;
    case SurfaceKind::kSphere:
      axes = surface_.Sphere().Position();
      ElSLib::Parameters(surface_.Sphere(), p, u, v);
      break;
    default:
      axes = surface_.Torus().Position();
      ElSLib::Parameters(surface_.Torus(), p, u, v);
  }
  if (face_->kind != SurfaceKind::kPlane) {
    // On the axis every direction is nearest: the seed's is kept.
    const gp_Vec from_axis = gp_Vec(axes.Location(), p).Crossed(gp_Vec(axes.Direction()));
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
  const bool u_gone = a <= std::pow(kCollapsed * speed_u_, 2);
  const bool v_gone = c <= std::pow(kCollapsed * speed_v_, 2);
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
