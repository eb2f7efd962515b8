// The next layer, planned before anything is inserted: where the kids go, which front vertices
// share one, and which cells they close (paper, II.C, II.F, II.G; corner classes as in paving).
#pragma once

#include <array>
#include <vector>

#include "layers/layer_state.h"

namespace advlayers {

struct Kid {
  SurfacePoint point;
  Vec3 normal = Vec3::Zero();
  std::vector<int> parents;  // front nodes joined to it by a parent-kid edge; the first extruded it
  int origin = -1;           // the node it is reached from; has no edge to it on a fan's diagonal
  Growth growth;             // after the layer
  int fan_age = -1;
  VertexH root;
  VertexH vertex;      // once inserted
  bool given = false;  // a vertex of the boundary: neither inserted nor moved
  bool tread = false;  // a low inner kid of coarsened edges, see thin_front.cpp
  double lag = 0.0;    // see FrontNode
  bool alive = true;
};

// A front vertex or a planned kid.
struct CellCorner {
  int node = -1, kid = -1;
};
inline CellCorner at_node(int i) { return {i, -1}; }
inline CellCorner at_kid(int k) { return {-1, k}; }

//   kid of a --- kid of b     An element of the layer, corners counter-clockwise, the first edge a
//       |           |         front edge or (in a fan) a parent-kid edge. `fronts` are the edges
//       that a --------- b         become front with it, each from kid to kid along the new front.
struct Cell {
  std::vector<CellCorner> corners;
  std::vector<std::array<int, 2>> fronts;
  bool layered = true;  // false: an element between layers, without a parent-kid edge
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
