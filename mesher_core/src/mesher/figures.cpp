#include "mesher/figures.h"

#include <algorithm>

namespace advlayers {
namespace {

double percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

}  // namespace

void FigureCounts::add(const ElementCorners& element, int layer) {
  const bool quad = element.count == 4;
  int& kind =
      layer > 0 ? (quad ? layer_quads_ : layer_triangles_) : (quad ? core_quads_ : core_triangles_);
  ++kind;
  const auto angles = interior_angles(element);
  for (int k = 0; k < element.count; ++k) {
    const double angle = angles[static_cast<std::size_t>(k)];
    ++angles_;
    within_45_135_ += angle >= 45.0 && angle <= 135.0;
    below_20_ += angle < 20.0;
    above_160_ += angle > 160.0;
    min_angle_ = std::min(min_angle_, angle);
    max_angle_ = std::max(max_angle_, angle);
  }
}

void FigureCounts::add(const FigureCounts& other) {
  layer_quads_ += other.layer_quads_;
  layer_triangles_ += other.layer_triangles_;
  core_quads_ += other.core_quads_;
  core_triangles_ += other.core_triangles_;
  angles_ += other.angles_;
  within_45_135_ += other.within_45_135_;
  below_20_ += other.below_20_;
  above_160_ += other.above_160_;
  min_angle_ = std::min(min_angle_, other.min_angle_);
  max_angle_ = std::max(max_angle_, other.max_angle_);
  inverted_ += other.inverted_;
}

Figures FigureCounts::figures(int nodes) const {
  Figures f;
  f.nodes = nodes;
  f.quads = layer_quads_ + core_quads_;
  f.triangles = layer_triangles_ + core_triangles_;
  f.quad_percent = percent(f.quads, f.quads + f.triangles);
  f.layer_quad_percent = percent(layer_quads_, layer_quads_ + layer_triangles_);
  f.core_quad_percent = percent(core_quads_, core_quads_ + core_triangles_);
  f.angles_45_135_percent = percent(within_45_135_, angles_);
  f.angles_below_20_percent = percent(below_20_, angles_);
  f.angles_above_160_percent = percent(above_160_, angles_);
  f.min_angle = angles_ > 0 ? min_angle_ : 0.0;
  f.max_angle = max_angle_;
  f.inverted = inverted_;
  return f;
}

}  // namespace advlayers
