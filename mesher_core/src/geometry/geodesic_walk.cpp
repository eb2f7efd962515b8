#include "geometry/geodesic_walk.h"

#include <algorithm>
#include <cmath>

namespace advlayers {

namespace {

// One step turns, or its parameters stretch, by at most so much [rad].
constexpr double kMaxTurn = 0.1;
// Steps in space win where those in (u, v) would have to be this much shorter.
constexpr double kWorthInSpace = 0.2;
// Below this turn the chord is the arc to 1e-9.
constexpr double kFlatTurn = 1e-4;
constexpr double kLengthError = 2e-7;  // relative
constexpr double kStepError = 5e-7;    // relative
constexpr int kMaxHalvings = 6;        // of one step
constexpr int kMaxSteps = 20000;       // a walk longer than that has no end

}  // namespace

GeodesicWalk::Rate GeodesicWalk::rate(double u, double v, const Vec3& heading) const {
  const SurfaceDerivatives s = surface_->second(u, v);
  Rate r{0.0, 0.0, Vec3::Zero(), 0.0, 0.0, surface_->regular(s.du, s.dv)};
  if (!r.regular) return r;
  const double e = s.du.squaredNorm(), f = s.du.dot(s.dv), g = s.dv.squaredNorm();
  const double det = e * g - f * f;
  const double a = heading.dot(s.du), b = heading.dot(s.dv);
  r.u = (g * a - f * b) / det;
  r.v = (e * b - f * a) / det;
  const Vec3 along_u = r.u * r.u * s.duu, along_v = r.v * r.v * s.dvv;
  const Vec3 across = 2.0 * r.u * r.v * s.duv;
  const Vec3 change = along_u + across + along_v;
  const Vec3 normal = s.du.cross(s.dv).normalized();
  const double curvature = change.dot(normal);
  r.heading = curvature * normal;
  r.bend = std::abs(curvature);
  // Summed up without their signs: on a saddle they cancel here, but not a step further.
  r.stretch = along_u.norm() + across.norm() + along_v.norm();
  return r;
}

bool GeodesicWalk::advance(double length) {
  if (kind_ == SurfaceKind::kPlane || kind_ == SurfaceKind::kCylinder) {
    // Straight lines of the developed surface are straight in (u, v).
    const Rate r = rate(at_.u, at_.v, heading_);
    at_.u += length * r.u;
    at_.v += length * r.v;
    const SurfaceFrame end = surface_->frame(at_.u, at_.v);
    at_.xyz = end.xyz;
    heading_ = r.u * end.du + r.v * end.dv;
    return true;
  }
  double left = length;
  for (int i = 0; i < kMaxSteps && left > kLengthError * length; ++i) {
    const Rate r = rate(at_.u, at_.v, heading_);
    const double in_parameters =
        r.regular ? std::min(left, kMaxTurn / std::max(r.stretch, 1e-300)) : 0.0;
    const double in_space = std::min(left, kMaxTurn / std::max(r.bend, 1e-300));
    if (in_parameters >= kWorthInSpace * in_space) {
      double h = in_parameters;
      if (step_in_parameters(r, h)) {
        left -= h;
        continue;
      }
    }
    double stride = in_space, walked = 0.0;
    while (!step_in_space(stride, stride == left, walked)) {
      stride *= 0.5;
      if (stride < 1e-6 * length) return false;
    }
    left -= walked;
  }
  return left <= kLengthError * length;
}

// Shortens `h` where a knot of the surface, or a pole ahead, spoils the step.
bool GeodesicWalk::step_in_parameters(const Rate& k1, double& h) {
  const GeodesicWalk start = *this;
  for (int attempt = 0; attempt < kMaxHalvings; ++attempt, h *= 0.5) {
    const auto ahead = [&](const Rate& k, double part) {
      return rate(start.at_.u + part * h * k.u, start.at_.v + part * h * k.v,
                  start.heading_ + part * h * k.heading);
    };
    const Rate k2 = ahead(k1, 0.5);
    const Rate k3 = ahead(k2, 0.5);
    const Rate k4 = ahead(k3, 1.0);
    if (!k2.regular || !k3.regular || !k4.regular) continue;
    at_.u = start.at_.u + h / 6.0 * (k1.u + 2.0 * k2.u + 2.0 * k3.u + k4.u);
    at_.v = start.at_.v + h / 6.0 * (k1.v + 2.0 * k2.v + 2.0 * k3.v + k4.v);
    heading_ =
        start.heading_ + h / 6.0 * (k1.heading + 2.0 * k2.heading + 2.0 * k3.heading + k4.heading);
    // Out of bounds may be across a pole, and on again beyond it.
    if (!surface_->in_bounds(at_.u, at_.v)) break;
    if (!level()) continue;
    const double turn2 = h * h * (k1.bend * k1.bend + 4.0 * k2.bend * k2.bend + k4.bend * k4.bend);
    const double chord = h * (1.0 - turn2 / (6.0 * 24.0));
    const double error = std::abs((at_.xyz - start.at_.xyz).norm() - chord);
    if (error <= kStepError * h || attempt + 1 == kMaxHalvings) return true;
  }
  *this = start;
  return false;
}

// Puts the point on the surface and the heading into its tangent plane.
bool GeodesicWalk::level() {
  const SurfaceFrame frame = surface_->frame(at_.u, at_.v);
  at_.xyz = frame.xyz;
  heading_ -= heading_.dot(frame.normal) * frame.normal;
  const double size = heading_.norm();
  heading_ /= size;
  return size > 0.5;
}

// The foot of the point `reach` ahead, lifted by what the surface falls away, so that the
// projection moves it hardly at all and keeps it straight ahead.
bool GeodesicWalk::land(const SurfaceFrame& frame, double reach, double& u, double& v,
                        Vec3& foot) const {
  const Vec3 ahead = at_.xyz + reach * heading_;
  Vec3 target = ahead;
  for (int pass = 0; pass < 2; ++pass) {
    if (!surface_->project(target, u, v, foot)) return false;
    target = ahead + (foot - ahead).dot(frame.normal) * frame.normal;
  }
  return true;
}

// Length of the arc to a near point, from its chords and their projected middle.
double GeodesicWalk::arc_length(double u, double v, const Vec3& xyz) const {
  const double chord = (xyz - at_.xyz).norm();
  double u_mid = 0.5 * (u + at_.u), v_mid = 0.5 * (v + at_.v);
  Vec3 middle;
  if (!surface_->project(0.5 * (xyz + at_.xyz), u_mid, v_mid, middle)) return chord;
  const double halves = (middle - at_.xyz).norm() + (xyz - middle).norm();
  return (4.0 * halves - chord) / 3.0;  // Richardson: the chord's error goes with the square
}

// False where the stretch is not nearly straight, or leaves the surface: nothing is changed then.
// An exact one is corrected until it is as long as asked.
bool GeodesicWalk::step_in_space(double length, bool exact, double& walked) {
  const SurfaceFrame frame = surface_->frame(at_.u, at_.v);
  double reach = length;
  for (int i = 0; i < 8; ++i) {
    double u = at_.u, v = at_.v;
    Vec3 foot;
    if (!land(frame, reach, u, v, foot)) return false;
    const double turn = 2.0 * (foot - at_.xyz - reach * heading_).norm() / reach;
    if (turn > 1.5 * kMaxTurn) return false;
    walked = turn < kFlatTurn ? (foot - at_.xyz).norm() : arc_length(u, v, foot);
    if (!(walked > 0.5 * length)) return false;
    if (!exact || std::abs(walked - length) <= kLengthError * length) {
      const Vec3 before = heading_;
      heading_ = (foot - at_.xyz).normalized();
      at_.u = u;
      at_.v = v;
      if (level()) return true;
      heading_ = before;
      return false;
    }
    reach *= length / walked;
  }
  return false;
}

}  // namespace advlayers
