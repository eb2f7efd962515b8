#include "triangulate/target_size.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kSmallestShare = 0.02;  // of the size, however curved the surface is

}  // namespace

TargetSize::TargetSize(Evaluator& evaluator, const Settings& settings)
    : evaluator_(&evaluator),
      sizes_(settings),
      chord_of_unit_radius_(2 * std::sin(settings.curvature_angle * M_PI / 360)) {}

double TargetSize::at(const SurfacePoint& p) {
  const double size = sizes_.near(p.xyz, p.face, sizes_.of_face(p.face));
  if (evaluator_->model().face(p.face).kind == SurfaceKind::kPlane) return size;
  const double curvature = evaluator_->max_curvature(p.face, p.u, p.v);
  if (!(curvature * size > chord_of_unit_radius_)) return size;  // also where it is not a number
  return std::max(chord_of_unit_radius_ / curvature, std::min(size, least(p.face)));
}

double TargetSize::least(FaceId face) const { return kSmallestShare * extent(face); }

double TargetSize::extent(FaceId face) const {
  return std::min(sizes_.of_face(face), std::sqrt(evaluator_->model().face(face).area));
}

}  // namespace advlayers
