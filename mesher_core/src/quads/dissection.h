// The best dissection of a small polygon of mesh vertices into quads alone, without a vertex more.
#pragma once

#include <array>
#include <vector>

#include "mesh/surface_mesh.h"

namespace advlayers {

inline constexpr std::size_t kMostCorners = 14;  // of a loop: the cost grows with their cube

struct Dissection {
  double worst = -1.0;  // quality of the worst quad, see quad_quality; -1: there is none
  std::vector<std::vector<VertexH>> quads;
};

// `loop`: the corners counter-clockwise, an even number from 4 to kMostCorners. No new side is
// longer than `longest` [mm], no quad worse than `least`. The worst quad is as good as can be:
// dynamic programming over the chords, n^4 / 24 quads measured.
Dissection dissect(const SurfaceMesh& mesh, const std::vector<VertexH>& loop, double longest,
                   double least);

}  // namespace advlayers
