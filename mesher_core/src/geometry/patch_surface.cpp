#include "geometry/patch_surface.h"

#include <algorithm>
#include <cmath>

namespace advlayers {

namespace {

// A sub-step turns at most so far [rad]: below it, the length by chords is right to 1e-7.
constexpr double kMaxTurn = 0.2;
// Below this turn the chord is the arc to 1e-9.
constexpr double kFlatTurn = 1e-4;
constexpr double kLengthError = 3e-7;  // relative
constexpr int kMaxSubsteps = 4096;

}  // namespace

PatchSurface::PatchSurface(Evaluator& evaluator, std::vector<FaceId> faces)
    : evaluator_(&evaluator), faces_(std::move(faces)) {}

bool PatchSurface::project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot) {
  return evaluator_->project(xyz, seed, foot);
}

// The foot of from + length * direction, with the seed moved by the first fundamental form.
bool PatchSurface::land(const SurfacePoint& from, const SurfaceFrame& frame, const Vec3& direction,
                        double length, SurfacePoint& to) {
  SurfacePoint seed = from;
  const double e = frame.du.squaredNorm(), f = frame.du.dot(frame.dv), g = frame.dv.squaredNorm();
  const double det = e * g - f * f;
  if (!frame.degenerate && det > 0.0) {
    const double a = direction.dot(frame.du), b = direction.dot(frame.dv);
    seed.u += length * (g * a - f * b) / det;
    seed.v += length * (e * b - f * a) / det;
  }
  return project(from.xyz + length * direction, seed, to);
}

// Length of the walked path between two near points, from its chords and their projected middle.
double PatchSurface::arc_length(const SurfacePoint& a, const SurfacePoint& b, double turn) {
  const double chord = (b.xyz - a.xyz).norm();
  if (turn < kFlatTurn) return chord;
  SurfacePoint middle;
  SurfacePoint seed = a;
  if (a.face == b.face) {
    seed.u = 0.5 * (a.u + b.u);
    seed.v = 0.5 * (a.v + b.v);
  }
  if (!project(0.5 * (a.xyz + b.xyz), seed, middle)) return chord;
  const double halves = (middle.xyz - a.xyz).norm() + (b.xyz - middle.xyz).norm();
  return (4.0 * halves - chord) / 3.0;  // Richardson: the chord's error goes with the square
}

bool PatchSurface::step(const SurfacePoint& from, const Vec3& direction, double length,
                        SurfacePoint& to) {
  SurfacePoint at = from;
  SurfaceFrame frame = evaluator_->frame(at.face, at.u, at.v);
  Vec3 heading = direction - direction.dot(frame.normal) * frame.normal;
  const double size = heading.norm();
  if (!(size > 1e-12 * direction.norm())) return false;
  heading /= size;
  double left = length, stride = length;
  for (int i = 0; i < kMaxSubsteps; ++i) {
    SurfacePoint next;
    SurfaceFrame next_frame;
    double walked = 0.0;
    stride = std::min(stride, left);
    const bool last = stride == left;
    if (!substep(at, frame, heading, stride, last, next, next_frame, walked)) {
      stride *= 0.5;
      if (stride < 1e-6 * length) return false;
      continue;
    }
    // The path's tangent at its end: the heading mirrored at the chord, laid into the surface.
    const Vec3 chord = (next.xyz - at.xyz).normalized();
    heading = 2.0 * chord.dot(heading) * chord - heading;
    heading = (heading - heading.dot(next_frame.normal) * next_frame.normal).normalized();
    at = next;
    frame = next_frame;
    left -= walked;
    if (last || left <= kLengthError * length) {
      to = at;
      return true;
    }
  }
  return false;
}

// One stretch short enough to be nearly straight; false where it is not, or leaves the surface. The
// last one is corrected until it is as long as asked.
bool PatchSurface::substep(const SurfacePoint& at, const SurfaceFrame& frame, const Vec3& heading,
                           double stride, bool exact, SurfacePoint& next, SurfaceFrame& next_frame,
                           double& walked) {
  double reach = stride;
  for (int i = 0; i < 8; ++i) {
    if (!land(at, frame, heading, reach, next)) return false;
    const Vec3 ahead = at.xyz + reach * heading;
    const double turn = 2.0 * (next.xyz - ahead).norm() / reach;
    if (turn > kMaxTurn) return false;
    if (i == 0) {
      next_frame = evaluator_->frame(next.face, next.u, next.v);
      if (next_frame.normal.dot(frame.normal) < std::cos(1.5 * kMaxTurn)) return false;
    }
    walked = arc_length(at, next, turn);
    if (!(walked > 0.5 * stride)) return false;
    if (!exact || std::abs(walked - stride) <= kLengthError * stride) {
      if (i > 0) next_frame = evaluator_->frame(next.face, next.u, next.v);
      return true;
    }
    reach *= stride / walked;
  }
  return false;
}

}  // namespace advlayers
