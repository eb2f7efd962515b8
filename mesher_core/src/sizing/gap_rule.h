// How high the last layers of a narrowing gap are. Shared by the boundary, which lays out the
// layers along match edges, and by the fronts that then run along them.
#pragma once

namespace advlayers {

// The height [mm] of the next layer where the next boundary or front lies `gap` ahead: as asked
// while `rows` of it, ours and the opposing one, leave at least one more, then an even share of the
// gap; 0 where those rows do not fit. A corner that runs ahead of its layer counts as more than
// one.
inline double height_in_gap(double height, double gap, double rows = 2.0) {
  if (gap >= (rows + 1.0) * height) return height;
  return gap >= rows * height ? gap / (rows + 1.0) : 0.0;
}

}  // namespace advlayers
