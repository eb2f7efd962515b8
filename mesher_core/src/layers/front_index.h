// A spatial index of all front and idle edges of a patch, for collisions (paper, II.J, against all
// edges instead of those that share a triangle).
#pragma once

#include <memory>
#include <vector>

#include "layers/front.h"

namespace advlayers {

class FrontIndex {
 public:
  FrontIndex(const SurfaceMesh& mesh, const Front& front);
  ~FrontIndex();

  struct Hit {
    double distance = 0.0;  // [mm]
    VertexH from, to;       // the edge's ends
    int node = -1;          // the front node that the edge starts from; -1: the edge is idle
  };
  // The nearest edge within `reach` of the node that lies ahead of it: less than 60 degrees off
  // `inward`, on the same side of the surface, and not joined to the node within two edges.
  // False where there is none.
  bool nearest_ahead(int node, const NodeShape& shape, double reach, Hit& hit) const;

 private:
  struct Tree;
  const SurfaceMesh* mesh_;
  const Front* front_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace advlayers
