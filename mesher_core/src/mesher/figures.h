// Quality figures of a finished mesh, counted as the report and the bars define them.
#pragma once

#include "measure/element_measures.h"

namespace advlayers {

// Percentages of elements (quads) and of interior angles; zero where there is none to count.
struct Figures {
  int nodes = 0, quads = 0, triangles = 0;
  double quad_percent = 0, layer_quad_percent = 0, core_quad_percent = 0;
  double angles_45_135_percent = 0, angles_below_20_percent = 0, angles_above_160_percent = 0;
  double min_angle = 0, max_angle = 0;  // [deg]
  int inverted = 0;                     // elements turned over against the surface
};

// The counts behind the figures; those of several patches add up.
class FigureCounts {
 public:
  // `layer` is the element's; 0: core.
  void add(const ElementCorners& element, int layer);
  void add_inverted() { ++inverted_; }
  void add(const FigureCounts& other);
  Figures figures(int nodes) const;

 private:
  int layer_quads_ = 0, layer_triangles_ = 0, core_quads_ = 0, core_triangles_ = 0;
  int angles_ = 0, within_45_135_ = 0, below_20_ = 0, above_160_ = 0;
  double min_angle_ = 360.0, max_angle_ = 0.0;
  int inverted_ = 0;
};

}  // namespace advlayers
