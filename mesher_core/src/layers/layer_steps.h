// Which of the steps that go beyond the paper a layer takes. The mesher takes them all; tests/bench
// leaves out one at a time, to measure what it is worth.
#pragma once

namespace advlayers {

struct LayerSteps {
  bool row_ends = true;    // at concave corners, before the collapse (row_ends.h)
  bool fans = true;        // of kids at convex corners of the boundary
  bool coarsening = true;  // three front edges become one without a triangle (thin_front.h)
  bool tips = true;        // sharp corners closed by a triangle (close_front.h)
  bool zips = true;        // ends of strips closed by quads
  bool rungs = true;       // across narrow gaps, node to node
  bool bridges = true;     // across narrow gaps, node to edge
  bool sharing = true;     // of gaps by opposing fronts, in equal rows (layer_heights.h)
  bool alignment = true;   // of opposing fronts, node to node (opposing_fronts.h)
  bool smoothing = true;   // of the newest layer (smooth.h)
};

struct OptionalStep {
  const char* name;
  bool LayerSteps::*member;
};
inline constexpr OptionalStep kOptionalSteps[] = {{"row ends", &LayerSteps::row_ends},
                                                  {"fans", &LayerSteps::fans},
                                                  {"3 to 1 coarsening", &LayerSteps::coarsening},
                                                  {"tips", &LayerSteps::tips},
                                                  {"zips", &LayerSteps::zips},
                                                  {"rungs", &LayerSteps::rungs},
                                                  {"bridges", &LayerSteps::bridges},
                                                  {"sharing of gaps", &LayerSteps::sharing},
                                                  {"alignment of fronts", &LayerSteps::alignment},
                                                  {"smoothing of layers", &LayerSteps::smoothing}};

}  // namespace advlayers
