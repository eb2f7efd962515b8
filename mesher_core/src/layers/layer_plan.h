// The next layer, planned before anything is inserted: where the kids go, which front vertices
// share one, and which cells they close (paper, II.C, II.F, II.G; corner classes as in paving).
#pragma once

#include <vector>

#include "layers/layer_state.h"

namespace advlayers {

struct Kid {
  SurfacePoint point;
  Vec3 normal = Vec3::Zero();
  std::vector<int> parents;  // front nodes joined to it by a parent-kid edge; the first extruded it
  int origin = -1;           // the node it is reached from; has no edge to it on a fan's diagonal
  double height = 0.0;       // of the next layer's extrusion [mm]
  double growth = 1.0;
  int layers_left = 0;
  int fan_age = -1;
  VertexH root;
  VertexH vertex;  // once inserted
  bool alive = true;
};

//   kid_from --- kid_to        A cell lies left of the front edge from -> to. Both kids the same: a
//      |            |          triangle. `middle` set: a row end, the quad from, middle, to, kid.
//    from -------- to          from == to: the quad that a fan adds, about its diagonal kid.
struct Cell {
  int from = -1, to = -1, middle = -1;
  int kid_from = -1, kid_to = -1, diagonal = -1;
  bool alive = true;
};

struct LayerPlan {
  std::vector<Kid> kids;
  std::vector<Cell> cells;
  std::vector<NodeShape> shapes;          // by front node
  std::vector<std::vector<int>> kids_of;  // by front node, in the order of the new front
};

// Plans a layer for all active nodes; nodes that have no room are stopped. The mesh stays as it is.
LayerPlan plan_layer(LayerState& state);

}  // namespace advlayers
