#include "geometry/patch_surface.h"

namespace advlayers {

PatchSurface::PatchSurface(Evaluator& evaluator, std::vector<FaceId> faces)
    : evaluator_(&evaluator), faces_(std::move(faces)) {}

bool PatchSurface::project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot) {
  return evaluator_->project(xyz, seed, foot);
}

bool PatchSurface::step(const SurfacePoint& from, const Vec3& direction, double length,
                        SurfacePoint& to) {
  const Vec3 normal = evaluator_->normal(from);
  Vec3 heading = direction - direction.dot(normal) * normal;
  const double size = heading.norm();
  if (!(size > 1e-9 * direction.norm())) return false;
  heading /= size;
  return evaluator_->walk(from, length, heading, to);
}

}  // namespace advlayers
