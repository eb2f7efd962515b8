// The surface of one face: evaluation and the foot of a point. For the sources of geometry/ alone.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <vector>

#include "geometry/evaluator.h"
#include "geometry/model.h"

namespace advlayers {

// The surface below any trimming; location is null where the face has none.
// Throws GeometryError if the face has no surface.
GeomAdaptor_Surface basis_surface(const TopoDS_Face& face, gp_Trsf& location, bool& located);

struct SurfaceDerivatives {
  Vec3 xyz, du, dv, duu, dvv, duv;
};

class FaceSurface {
 public:
  FaceSurface(const TopoDS_Face& shape, const Face& face);

  Vec3 value(double u, double v) const;
  void first(double u, double v, Vec3& xyz, Vec3& du, Vec3& dv) const;
  SurfaceDerivatives second(double u, double v) const;
  SurfaceFrame frame(double u, double v) const;
  double max_curvature(double u, double v) const;

  // Whether (u, v) lies where the surface exists, not just in its continuation.
  bool in_bounds(double u, double v) const;
  // Whether the derivatives span a plane well enough to move in (u, v) by them.
  bool regular(const Vec3& du, const Vec3& dv) const;
  double size() const { return size_; }

  // The foot near (u, v), which become its parameters. False: no stationary point was reached; the
  // nearest point seen is returned then.
  bool project(const Vec3& point, double& u, double& v, Vec3& foot) const;

 private:
  // Below this part of the typical |Su| a direction is rounding noise: the surface is collapsed
  // there.
  static constexpr double kCollapsed = 1e-8;
  bool u_collapsed(const Vec3& du) const { return du.norm() <= kCollapsed * speed_u_; }
  bool v_collapsed(const Vec3& dv) const { return dv.norm() <= kCollapsed * speed_v_; }

  bool is_elementary() const { return face_->kind != SurfaceKind::kOther; }
  void keep_elementary();
  void wrap(double& u, double& v) const;
  void step_inside(double& u, double& v, double fraction, bool along_u, bool along_v) const;
  bool spans_plane(const Vec3& du, const Vec3& dv) const;
  void project_elementary(const Vec3& point, double& u, double& v, Vec3& foot) const;
  void cross_pole(const Vec3& point, double& u, double& v, Vec3& foot) const;
  bool newton(const Vec3& point, double& u, double& v, Vec3& foot) const;
  bool backtrack(const Vec3& point, double du, double dv, double& u, double& v,
                 SurfaceDerivatives& s, double& distance2) const;
  bool descends(const Vec3& point, double u, double v, double distance) const;
  void clamp(double& u, double& v) const;
  bool newton_step(const Vec3& point, double u, double v, const SurfaceDerivatives& s, double& du,
                   double& dv) const;

  const GeomAdaptor_Surface& adaptor(double u, double v) const;
  void index_spans();

  const Face* face_;
  gp_Trsf location_, inverse_;
  bool located_ = false;
  GeomAdaptor_Surface surface_;  // after the location, which its making sets
  // A B-spline's adaptor keeps the polynomial of the span that it was asked for last, and making
  // one costs far more than its evaluation: each span has an adaptor of its own, or shares it with
  // others far away. By slot, made when asked for.
  mutable std::vector<std::unique_ptr<GeomAdaptor_Surface>> by_span_;
  std::vector<double> u_knots_, v_knots_;  // empty: one span, or no B-spline
  gp_Ax3 axes_;                            // of an elementary surface
  double radius_ = 0.0, second_ = 0.0;     // and its radius; cone: angle [rad], torus: minor radius
  double scale_ = 1.0;                     // of the location
  double u_lo_, u_hi_, v_lo_, v_hi_;       // where the surface exists
  double speed_u_ = 0.0, speed_v_ = 0.0;   // typical |Su|, |Sv| over the face
  double size_ = 0.0;                      // of the face, about [mm]
};

}  // namespace advlayers
