#include "triangulate/target_size.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr double kSmallestShare = 0.02;  // of the size, however curved the surface is
constexpr double kCoarse = 50.0;  // times the size: no more than the border and curvature ask for

}  // namespace

TargetSize::TargetSize(Evaluator& evaluator, const Settings& settings, Density density)
    : evaluator_(&evaluator),
      sizes_(settings),
      chord_of_unit_radius_(2 * std::sin(settings.curvature_angle * M_PI / 360)),
      chord_deviation_(settings.chord_deviation),
      min_size_(settings.min_size),
      density_(density) {
  // The chord's distance from its arc over its length is an eighth of the angle.
  if (settings.relative_chord > 0.0) {
    chord_of_unit_radius_ = std::min(chord_of_unit_radius_, 8.0 * settings.relative_chord);
  }
}

double TargetSize::at(const SurfacePoint& p) {
  const double size = density_ == Density::kCoarse
                          ? kCoarse * sizes_.of_face(p.face)
                          : sizes_.near(p.xyz, p.face, sizes_.of_face(p.face));
  if (evaluator_->model().face(p.face).kind == SurfaceKind::kPlane) return size;
  const double curvature = evaluator_->max_curvature(p.face, p.u, p.v);
  double chord = chord_of_unit_radius_ / curvature;
  if (chord_deviation_ > 0.0)
    chord = std::min(chord, std::sqrt(8.0 * chord_deviation_ / curvature));
  if (!(chord < size)) return size;  // also where it is not a number
  return std::max(chord, std::min(size, std::max(min_size_, least(p.face))));
}

double TargetSize::least(FaceId face) const { return kSmallestShare * extent(face); }

double TargetSize::extent(FaceId face) const {
  return std::min(sizes_.of_face(face), std::sqrt(evaluator_->model().face(face).area));
}

}  // namespace advlayers
