// The triangulation of one face in its sheet, with its points evaluated on the surface. Lengths and
// angles are those of the first fundamental form; orientation is that of the sheet, exact, so that
// the triangulation stays valid however coarse it is on the surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "triangulate/face_sheet.h"
#include "triangulate/planar_triangulation.h"
#include "triangulate/target_size.h"

namespace advlayers {

// First fundamental form per unit of the sheet.
struct Metric {
  double e = 0, f = 0, g = 0;

  double squared(const Vec2& d) const {
    return e * d.x() * d.x() + 2 * f * d.x() * d.y() + g * d.y() * d.y();
  }
  double dot(const Vec2& a, const Vec2& b) const {
    return e * a.x() * b.x() + f * (a.x() * b.y() + a.y() * b.x()) + g * a.y() * b.y();
  }
  double determinant() const { return e * g - f * f; }
  // d turned left by a right angle, as long as d.
  Vec2 across(const Vec2& d) const {
    const double area = std::sqrt(std::max(determinant(), 1e-300));
    return {-(f * d.x() + g * d.y()) / area, (e * d.x() + f * d.y()) / area};
  }
  Metric operator+(const Metric& o) const { return {e + o.e, f + o.f, g + o.g}; }
  Metric operator*(double s) const { return {s * e, s * f, s * g}; }
};

struct LiftedVertex {
  SurfacePoint point;
  Vec3 normal;  // of the surface; on a border that ends in an unresolved nose, of the surface
                // beside it
  Metric metric;
  double size = 0;   // wanted edge length [mm], graded
  double least = 0;  // what a long border nearby makes of it, however curved the surface [mm]
  NodeId node;       // on the face's boundary
  bool pole = false;
  bool crease = false;  // on a fold too sharp to be followed: its normal says nothing
};

class LiftedTriangulation {
 public:
  using Side = PlanarTriangulation::Side;

  // `mesh` triangulates the sheet's points (and may hold more points, in no triangle); a segment
  // mark in it is an index into sheet.segments.
  LiftedTriangulation(FaceSheet sheet, PlanarTriangulation mesh, Evaluator& evaluator,
                      TargetSize target);

  const FaceSheet& sheet() const { return sheet_; }
  const Face& face() const { return evaluator_->model().face(sheet_.face); }
  const PlanarTriangulation& mesh() const { return mesh_; }
  double gradation() const { return target_.gradation(); }  // of sizes, per length
  const LiftedVertex& vertex(int v) const { return vertices_[static_cast<std::size_t>(v)]; }
  // Raised whenever a triangle changes.
  unsigned version(int t) const { return versions_[static_cast<std::size_t>(t)]; }
  const std::vector<int>& touched() const { return touched_; }  // by the last insertion

  double squared_length(int a, int b) const;
  // How far the chord of a boundary segment strays from the surface [mm].
  double sagitta(int segment) const { return sagittas_[static_cast<std::size_t>(segment)]; }

  LiftedVertex evaluate(const Vec2& p);
  double wanted_size(const Vec2& p) { return target_.at(evaluate(p).point); }  // ungraded [mm]
  double least_size() const { return target_.least(sheet_.face); }             // ever wanted [mm]
  double area() const { return evaluator_->model().face(sheet_.face).area; }   // [mm^2]
  void mark_crease(int v) { vertices_[static_cast<std::size_t>(v)].crease = true; }

  // Inserts a point inside triangle t, or on side s, and flips edges until the triangulation is
  // Delaunay in the surface's metric about it. Returns the vertex, or -1, and changes nothing,
  // where rounding leaves no room for the point.
  int insert_in(int t, const Vec2& p);
  int insert_on(Side s, const Vec2& p);

  // Numbers the triangles by their corners: equal triangulations that came about in different
  // ways are the same from here on.
  void put_in_order(const RunContext& context);
  // Flips every edge that is not Delaunay in the metric.
  void flip_all();
  // Flips edges about poles by what the triangles are in space: seen from the pole, their
  // far sides must go round in order, which the sheet does not tell.
  void straighten_poles();
  // Whether t is nothing in space: one of its sides is a pole.
  bool vanishes(int t) const;

 private:
  int add_vertex(const Vec2& p, std::initializer_list<int> near);
  void settle(int v);
  void touch(int t);
  bool wants_flip(Side s) const;
  bool is_better_in_space(Side s) const;
  double score(int a, int b, int c) const;
  void set_boundary_sizes();
  void set_sagittas();
  void blunt_border_normals();
  void set_pole_sizes(const SheetSegment& pole);

  FaceSheet sheet_;
  PlanarTriangulation mesh_;
  Evaluator* evaluator_;
  TargetSize target_;
  std::vector<LiftedVertex> vertices_;
  std::vector<double> sagittas_;  // by segment
  std::vector<unsigned> versions_;
  std::vector<int> touched_;
  std::vector<Side> pending_;
};

}  // namespace advlayers
