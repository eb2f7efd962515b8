// Exact evaluation of the model's curves and surfaces. One Evaluator per thread: OpenCASCADE's
// adaptors cache the knot span they were last asked about. Cheap to make; adaptors are made lazily.
#pragma once

#include <memory>
#include <vector>

#include "base/types.h"
#include "geometry/model.h"

namespace advlayers {

// S(u, v), its first derivatives and the outward unit normal. At a pole or tip, where the
// derivatives do not span a plane, the normal is the limit from inside the face; `degenerate` says
// so.
struct SurfaceFrame {
  Vec3 xyz, du, dv, normal;
  bool degenerate = false;
};

class Evaluator {
 public:
  explicit Evaluator(const Model& model);
  ~Evaluator();
  Evaluator(Evaluator&&) noexcept;

  const Model& model() const;

  SurfaceFrame frame(FaceId face, double u, double v);
  Vec3 normal(const SurfacePoint& p) { return frame(p.face, p.u, p.v).normal; }

  // Largest absolute principal curvature [1/mm] at a point.
  double max_curvature(FaceId face, double u, double v);

  // The foot of `xyz` on the face's surface, by Newton from the seed's (u, v); the (u, v) of a
  // closed surface are kept near the seed's (they may leave the base period). Untrimmed.
  // Returns false, and leaves `foot` at the best point seen, where Newton does not converge.
  bool project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot);

  // The foot of `xyz` on the trimmed face without a seed: a search over samples of the face first.
  // Throws GeometryError for a face with a defect.
  SurfacePoint closest(FaceId face, const Vec3& xyz);

  // Whether (u, v) lies on the trimmed face, by whole periods if need be. The boundary is a polygon
  // here, within 1e-4 of the face's extent: as near to it as that, either answer may come.
  bool inside(FaceId face, double u, double v);

  // Walks `length` [mm] from `from` along the face's untrimmed surface, as straight as it allows;
  // `heading`, a unit tangent, is that at the end afterwards. The arc walked is `length` to 1e-6
  // relative. Returns false, with `to` and `heading` void, where the surface ends before.
  bool walk(const SurfacePoint& from, double length, Vec3& heading, SurfacePoint& to);

  Vec3 edge_point(EdgeId edge, double t);
  Vec3 edge_tangent(EdgeId edge, double t);      // dC/dt, not normalized
  double edge_curvature(EdgeId edge, double t);  // [1/mm]
  // Length of the curve between two parameters [mm]; negative where t1 < t0.
  double edge_length(EdgeId edge, double t0, double t1);
  // The parameter at which that length has been walked from t0, to round-off; held in the range.
  double edge_parameter(EdgeId edge, double t0, double length);
  // Ends and inner joints of the smooth pieces that the edge's curve is made of.
  std::vector<double> edge_pieces(EdgeId edge);
  // Parameters inside the edge's range where its tangent turns at once by more than `angle` [rad].
  std::vector<double> edge_kinks(EdgeId edge, double angle);
  // (u, v) of the edge's point on the face, by the co-edge's curve in (u, v), or, where that curve
  // strays from the edge in space by more than the tolerance, by projection. Continuous along a
  // loop.
  Vec2 edge_uv(FaceId face, const CoEdge& coedge, double t);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace advlayers
