#include "triangulate/target_size.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kSmallestShare = 0.02;

}  // namespace

TargetSize::TargetSize(Evaluator& evaluator, const Settings& settings)
    : evaluator_(&evaluator),
      size_(settings.size),
      chord_of_unit_radius_(2 * std::sin(settings.curvature_angle * M_PI / 360)) {}

double TargetSize::at(const SurfacePoint& p) {
  if (evaluator_->model().face(p.face).kind == SurfaceKind::kPlane) return size_;
  const double curvature = evaluator_->max_curvature(p.face, p.u, p.v);
  if (!(curvature * size_ > chord_of_unit_radius_)) return size_;  // also where it is not a number
  return std::max(chord_of_unit_radius_ / curvature, least(p.face));
}

double TargetSize::least(FaceId face) const { return kSmallestShare * extent(face); }

double TargetSize::extent(FaceId face) const {
  return std::min(size_, std::sqrt(evaluator_->model().face(face).area));
}

}  // namespace advlayers
