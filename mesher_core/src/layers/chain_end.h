// The ends of open chains. A chain that ends beside a boundary edge that is no wall runs along it:
// its end takes the edge's own nodes as kids. Any other end steps down, one column per layer.
#pragma once

#include "layers/layer_state.h"

namespace advlayers {

//   core    |                      slides: the kid of the end v is the boundary's next node b.
//       b - k     b: next node     stands: where b lies too far ahead, or the boundary too slant,
//       |   |     k: kid of n      v is its own kid, and the layer ends in the triangle v n k.
//       v - n
struct EndStep {
  VertexH kid;          // invalid: neither, the end steps down
  double height = 0.0;  // as asked, or less in a narrowing gap; 0: there is no room [mm]
  double lag = 0.0;     // of the kid behind its layer, along the boundary [mm]
};

// The nodes of the front by vertex, where chains end.
class ChainEnds {
 public:
  explicit ChainEnds(const LayerState& state);

  // The step of a chain's end by a layer of `height`. Where it `follows` its neighbour, that one
  // has found out already how narrow the gap ahead is.
  EndStep step(int node, double height, bool follows) const;
  // Two chains whose ends face each other along the boundary, too near for two more layers, become
  // one: the boundary's edge between them closes the gap.
  static void join_facing(LayerState& state);

 private:
  double room_along(VertexH from, bool forward, double most) const;

  const LayerState& state_;
  std::vector<VertexH> on_front_;  // sorted; empty where no chain ends
};

bool is_chain_end(const FrontNode& node);

}  // namespace advlayers
