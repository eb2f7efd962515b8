#include "geometry/face_surface.h"

#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

// Sine below which the direction of the derivatives' cross product is round-off: parameter lines
// that touch along an edge of the face are no rarity in lofted surfaces.
constexpr double kParallel = 1e-6;
// Below this part the parameter plane is too stretched to steer in.
constexpr double kRegular = 1e-3;
// Part of a period by which round-off may lead beyond it.
constexpr double kRoundOff = 1e-12;
constexpr std::size_t kMostSpans = 1024;  // with an adaptor of their own

// x by whole periods into the range. A hair beyond an end stays at that end: where the surface is
// creased along its seam, the other end has another normal.
double wrapped(double x, double lo, double hi, double period) {
  if (!(period > 0.0) || (x >= lo && x <= hi)) return x;
  const double slack = kRoundOff * period;
  if (x >= lo - slack && x <= hi + slack) return std::clamp(x, lo, hi);
  return x - period * std::floor((x - lo) / period);
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
  keep_elementary();
  if (surface_.GetType() == GeomAbs_BSplineSurface) index_spans();
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

// Asking the adaptor for its plane or cylinder costs more than the projection onto it.
void FaceSurface::keep_elementary() {
  switch (face_->kind) {
    case SurfaceKind::kPlane:
      axes_ = surface_.Plane().Position();
      break;
    case SurfaceKind::kCylinder:
      axes_ = surface_.Cylinder().Position();
      radius_ = surface_.Cylinder().Radius();
      break;
    case SurfaceKind::kCone:
      axes_ = surface_.Cone().Position();
      radius_ = surface_.Cone().RefRadius();
      second_ = surface_.Cone().SemiAngle();
      break;
    case SurfaceKind::kSphere:
      axes_ = surface_.Sphere().Position();
      radius_ = surface_.Sphere().Radius();
      break;
    case SurfaceKind::kTorus:
      axes_ = surface_.Torus().Position();
      radius_ = surface_.Torus().MajorRadius();
      second_ = surface_.Torus().MinorRadius();
      break;
    case SurfaceKind::kOther:
      break;
  }
}

void FaceSurface::index_spans() {
  const Handle(Geom_BSplineSurface) spline = surface_.BSpline();
  for (int k = 1; k <= spline->NbUKnots(); ++k) u_knots_.push_back(spline->UKnot(k));
  for (int k = 1; k <= spline->NbVKnots(); ++k) v_knots_.push_back(spline->VKnot(k));
  const std::size_t spans = (u_knots_.size() - 1) * (v_knots_.size() - 1);
  if (spans > 1) by_span_.resize(std::min(spans, kMostSpans));
}

const GeomAdaptor_Surface& FaceSurface::adaptor(double u, double v) const {
  if (by_span_.empty()) return surface_;
  const auto span = [](const std::vector<double>& knots, double x) {
    const auto after = std::upper_bound(knots.begin() + 1, knots.end() - 1, x);
    return static_cast<std::size_t>(after - knots.begin()) - 1;
  };
  const std::size_t place = span(u_knots_, u) * (v_knots_.size() - 1) + span(v_knots_, v);
  std::unique_ptr<GeomAdaptor_Surface>& slot = by_span_[place % by_span_.size()];
  if (!slot) slot = std::make_unique<GeomAdaptor_Surface>(surface_.Surface());
  return *slot;
}

// OpenCASCADE evaluates a closed surface that is not flagged periodic inside its range only.
void FaceSurface::wrap(double& u, double& v) const {
  if (is_elementary()) return;
  u = wrapped(u, u_lo_, u_hi_, face_->u_period);
  v = wrapped(v, v_lo_, v_hi_, face_->v_period);
}

Vec3 FaceSurface::value(double u, double v) const {
  wrap(u, v);
  gp_Pnt p;
  adaptor(u, v).D0(u, v, p);
  if (located_) p.Transform(location_);
  return to_vec(p);
}

void FaceSurface::first(double u, double v, Vec3& xyz, Vec3& du, Vec3& dv) const {
  wrap(u, v);
  gp_Pnt p;
  gp_Vec pu, pv;
  adaptor(u, v).D1(u, v, p, pu, pv);
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
  adaptor(u, v).D2(u, v, p, pu, pv, puu, pvv, puv);
  if (located_) {
    p.Transform(location_);
    for (gp_Vec* d : {&pu, &pv, &puu, &pvv, &puv}) d->Transform(location_);
  }
  return {to_vec(p), to_vec(pu), to_vec(pv), to_vec(puu), to_vec(pvv), to_vec(puv)};
}

bool FaceSurface::spans_plane(const Vec3& du, const Vec3& dv) const {
  const double a = du.norm(), b = dv.norm();
  return !u_collapsed(du) && !v_collapsed(dv) && du.cross(dv).norm() > kParallel * a * b;
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
  const bool u_gone = u_collapsed(f.du), v_gone = v_collapsed(f.dv);
  const bool both = u_gone == v_gone;
  for (const double fraction : {1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
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

}  // namespace advlayers
