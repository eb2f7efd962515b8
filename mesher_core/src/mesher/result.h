// The finished mesh of the whole model: plain arrays, frozen.
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "layers/patch_layers.h"
#include "mesher/figures.h"

namespace advlayers {

// The top of a column, and the layer that was not made there.
struct StopPlace {
  Vec3 point = Vec3::Zero();
  int layer = 0;
};

// What was asked of one wall edge on one face, and what the final mesh measures there.
struct WallReport {
  EdgeId edge;
  FaceId face;
  double first_height = 0.0;  // asked [mm]; the mean over the columns measured where it varies
  std::vector<double> first_heights;  // asked at each node of the edge, where it varies [mm]
  double growth = 1.0;                // asked
  int requested_layers = 0;           // 0: until the fronts close, unless `until_isotropic`
  bool until_isotropic = false;
  double thickness = 0.0;  // of all layers asked for [mm]; 0 where their number is not
  double achieved_min = 0.0, achieved_mean = 0.0, achieved_max = 0.0;  // first height [mm]
  double height_error = 0.0;     // the largest |achieved / asked - 1| of a first height
  double achieved_growth = 0.0;  // mean over columns; 0 where no column has two layers
  double thickness_min = 0.0, thickness_mean = 0.0, thickness_max = 0.0;  // achieved [mm]
  int layers = 0;                                // complete layers along the whole edge
  std::map<std::string, int> stops;              // reason -> wall vertices
  std::map<std::string, StopPlace> first_stops;  // reason -> where a column ended so at the fewest
};

struct PatchReport {
  PatchId patch;
  std::vector<FaceId> faces;
  int layers = 0, quads = 0, triangles = 0;
  std::map<std::string, int> events;              // collapse, row-end, … -> count
  std::map<std::string, int> triangles_by_cause;  // as triangle_causes() has it
  std::map<std::string, int> vetoes;
};

struct MeshResult {
  std::vector<Vec3> nodes;
  std::vector<std::array<int, 4>>
      quads;  // zero-based, counter-clockwise against the outward normal
  std::vector<std::array<int, 3>> triangles;
  std::vector<FaceId> quad_face, triangle_face;
  std::vector<int> quad_layer, triangle_layer;  // 0: core
  std::vector<int> node_parent;                 // -1: none
  std::vector<int> node_layer;
  // Of order 2 alone: their numbers go on after those of `nodes`. Mid node k of an element lies
  // between its corners k and k + 1.
  std::vector<Vec3> mid_nodes;
  std::vector<std::array<int, 4>> quad_mids;
  std::vector<std::array<int, 3>> triangle_mids;
  // Mesh edges on CAD edges: node pairs, by EdgeId.
  std::vector<std::vector<std::array<int, 2>>> edge_segments;
  std::vector<std::vector<int>> segment_mids;  // of order 2, beside edge_segments
  // By entry of the settings' periodic: nodes that its motion brings onto others, with those.
  std::vector<std::vector<std::array<int, 2>>> periodic_nodes;
  std::vector<PatchReport> patches;
  std::vector<WallReport> walls;  // empty in a snapshot
  Figures figures;                // all zero in a snapshot
  std::vector<Diagnostic> diagnostics;
  std::map<std::string, double> seconds;  // boundary, triangulate, layers, core
};

}  // namespace advlayers
