// How high the last layers of a narrowing gap are. Shared by the boundary, which lays out the
// layers along match edges, and by the fronts that then run along them.
#pragma once

namespace advlayers {

// The height [mm] of the next layer where the next boundary or front lies `gap` ahead: as asked
// while two more layers leave at least one, then a third of the gap; 0 where two do not fit.
inline double height_in_gap(double height, double gap) {
  if (gap >= 3.0 * height) return height;
  return gap >= 2.0 * height ? gap / 3.0 : 0.0;
}

}  // namespace advlayers
