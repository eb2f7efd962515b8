// The pieces in which edges are cut.
#pragma once

#include <vector>

#include "boundary/edge_spacing.h"

namespace advlayers {

// A stretch of an edge between two joints: CAD vertices, or kinks of the curve.
struct Stretch {
  EdgeId edge;
  double t_begin, t_end;
  int joints[2];
  int required = 1;  // segments
  EdgeSpacing spacing;
};

struct Stretches {
  std::vector<Stretch> all;
  std::vector<std::vector<std::size_t>> of_edge;  // by EdgeId, into `all`, along the edge

  const std::vector<std::size_t>& of(EdgeId edge) const { return of_edge[edge.index()]; }
  Stretch& operator[](std::size_t i) { return all[i]; }
  const Stretch& operator[](std::size_t i) const { return all[i]; }
};

}  // namespace advlayers
