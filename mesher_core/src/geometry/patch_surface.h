// The surface under one patch, as the front sees it: one smooth surface, whichever CAD face a point
// lies on. A point that leaves its face over an edge inside the patch continues on the neighbour.
#pragma once

#include <vector>

#include "geometry/evaluator.h"

namespace advlayers {

class PatchSurface {
 public:
  PatchSurface(Evaluator& evaluator, std::vector<FaceId> faces);

  const std::vector<FaceId>& faces() const { return faces_; }
  Vec3 normal(const SurfacePoint& p) { return evaluator_->normal(p); }

  // The foot of `xyz`, from a seed. Returns false where no foot is found near the seed.
  bool project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot);

  // Walks `length` [mm] along the surface from `from`, starting in `direction` (any vector with a
  // part in the tangent plane; need not be a unit vector), as straight as the surface allows:
  // predicted by the first fundamental form, corrected by projection, sub-stepped where curvature x
  // step is large. The arc length from `from` to `to` is `length` to 1e-6 relative.
  bool step(const SurfacePoint& from, const Vec3& direction, double length, SurfacePoint& to);

 private:
  Evaluator* evaluator_;
  std::vector<FaceId> faces_;
};

}  // namespace advlayers
