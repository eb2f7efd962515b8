// The curve of one edge: evaluation, arc length and its inverse. For the sources of geometry/
// alone.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <vector>

#include "geometry/model.h"

namespace advlayers {

class EdgeCurve {
 public:
  EdgeCurve(const TopoDS_Edge& shape, const Edge& edge, const Vec3& pole);

  Vec3 value(double t) const;
  Vec3 tangent(double t) const;
  double curvature(double t) const;
  // Both work on the whole edge: length from the first parameter, and its inverse.
  double length_at(double t);
  double parameter_at(double length);
  std::vector<double> pieces() const;
  std::vector<double> kinks(double angle) const;

 private:
  double speed(double t) const { return tangent(t).norm(); }
  double gauss(double a, double b) const;
  void build_table();
  void refine(double a, double b, double whole, double floor, int depth);
  std::vector<double> breaks(GeomAbs_Shape continuity) const;

  const Edge* edge_;
  BRepAdaptor_Curve curve_;  // empty for a degenerate edge
  Vec3 pole_;
  // Cells small enough for the quadrature: length_[i] at params_[i].
  std::vector<double> params_, lengths_;
};

}  // namespace advlayers
