// Layers of walls that run along another edge: its nodes are to lie where they end.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "base/types.h"
#include "sizing/wall_spacing.h"

namespace advlayers {

// At one end of a match edge, the wall that meets it there.
struct MatchEnd {
  EdgeId edge;
  int end = 0;  // 0: at the edge's first parameter, 1: at its last
  EdgeId wall;
  int wall_end = 0;
  FaceId face;  // on which they meet
  WallSpacing spacing;
  double sine = 1.0;  // of the angle between wall and edge
  bool stop_at_isotropy = false;
  double max_height = 0.0;  // no layer is higher [mm]
};

// The heights of a wall's layers, one after the other.
struct LayerSeries {
  double height = 0.0;  // of the next layer [mm]
  double growth = 1.0;
  int layers = kUntilClosed;
  double most = 0.0;                                           // no layer is higher [mm]
  double isotropic = std::numeric_limits<double>::infinity();  // none so high is made [mm]
  double sine = 1.0;
};

// The edge's first segments from either end [mm]; `closed`: what is left between them is one
// segment, which the fronts from both ends close.
struct LayeredCuts {
  std::array<std::vector<double>, 2> segments;
  bool closed = false;
  double spread = 0.0;  // the largest deviation of a series from the mean that the nodes follow
};

// Lays out the layers along `length` of an edge, from the walls at its ends (of several at one end,
// faces on both sides of the edge, the mean), by the rule by which fronts end.
LayeredCuts lay_out_layers(double length, std::vector<LayerSeries> begin,
                           std::vector<LayerSeries> end);

}  // namespace advlayers
