// Quality figures of a finished mesh, counted as the report and the bars define them.
#pragma once

#include "mesher/result.h"

namespace advlayers {

struct Figures {
  int nodes = 0, quads = 0, triangles = 0;
  double quad_percent = 0, layer_quad_percent = 0, core_quad_percent = 0;
  double angles_45_135_percent = 0, angles_below_20_percent = 0, angles_above_160_percent = 0;
  double min_angle = 0, max_angle = 0;  // [deg]
  int inverted = 0;                     // elements turned over against the surface
};

}  // namespace advlayers
