// A walk straight on along the surface of one face. For the sources of geometry/ alone.
//
// A geodesic has no curvature but the surface's: x'' = II(x', x') n. Where the parameters serve,
// this is integrated in (u, v) with the tangent in space (Runge-Kutta, fourth order, no
// projection); near poles and tips, where (u, v) turn wild, by projected steps in space alone.
#pragma once

#include "geometry/face_surface.h"

namespace advlayers {

class GeodesicWalk {
 public:
  // `heading`: a unit vector in the tangent plane.
  GeodesicWalk(const FaceSurface& surface, SurfaceKind kind, const SurfacePoint& from,
               const Vec3& heading)
      : surface_(&surface), kind_(kind), at_(from), heading_(heading) {}

  // False where the surface ends before `length` is walked.
  bool advance(double length);

  const SurfacePoint& point() const { return at_; }
  const Vec3& heading() const { return heading_; }

 private:
  struct Rate {
    double u, v;
    Vec3 heading;
    double bend;     // |curvature| along the heading [1/mm]
    double stretch;  // how fast the parameters turn and stretch, bend included [1/mm]
    bool regular;
  };
  Rate rate(double u, double v, const Vec3& heading) const;
  bool step_in_parameters(const Rate& start, double& length);
  bool step_in_space(double length, bool exact, double& walked);
  bool land(const SurfaceFrame& frame, double reach, double& u, double& v, Vec3& foot) const;
  double arc_length(double u, double v, const Vec3& xyz) const;
  bool level();

  const FaceSurface* surface_;
  SurfaceKind kind_;
  SurfacePoint at_;
  Vec3 heading_;
};

}  // namespace advlayers
