// The front: where the layers end and the core begins. Nodes form closed rings, or open chains
// where a neighbour was stopped; each edge prev -> next has the core on its left.
#pragma once

#include <limits>
#include <vector>

#include "geometry/patch_surface.h"
#include "layers/growth.h"
#include "layers/patch_layers.h"
#include "layers/wall_plan.h"
#include "mesh/surface_mesh.h"
#include "mesh/triangle_measures.h"

namespace advlayers {

struct FrontNode {
  VertexH vertex;
  int prev = -1, next = -1;  // along the front; -1: the chain ends here
  Growth growth;
  VertexH root;      // the wall vertex whose column this is
  int fan_age = -1;  // layers since a fan made it; -1: not of a fan
  double lag = 0.0;  // of a chain's end behind its layer, along the boundary [mm]
  bool active = true;
};

// The front's geometry at a node, in the tangent plane there.
struct NodeShape {
  Vec3 normal = Vec3::Zero();
  Vec3 to_next = Vec3::Zero(), to_prev = Vec3::Zero();  // unit vectors; mirrored at a chain's end
  Vec3 inward = Vec3::Zero();                   // unit bisector of the interior angle (paper, II.C)
  double length_next = 0.0, length_prev = 0.0;  // [mm]
  double angle = M_PI;                          // interior angle, 0 … 2 pi

  double turn() const { return M_PI - angle; }  // positive where the front is concave
  double length() const { return 0.5 * (length_next + length_prev); }
  double shorter() const { return std::min(length_next, length_prev); }
};

class Front {
 public:
  // Rings and chains of the mesh's border edges that are walls.
  Front(const SurfaceMesh& mesh, const WallPlan& plan);

  std::vector<FrontNode>& nodes() { return nodes_; }
  const std::vector<FrontNode>& nodes() const { return nodes_; }
  FrontNode& operator[](int i) { return nodes_[static_cast<std::size_t>(i)]; }
  const FrontNode& operator[](int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(nodes_.size()); }
  int active_count() const;

  // Edges with the core on their left that nothing grows from any more.
  const std::vector<HalfedgeH>& idle_edges() const { return idle_edges_; }
  void add_idle_edge(HalfedgeH h) { idle_edges_.push_back(h); }

  // Takes the nodes of a consumed run out and joins what is left on both sides.
  void bridge(int before, int after);
  // Joins p's and q's runs by an edge between them that both runs turn back at: the front then runs
  // prev(p), p, q', next(q) and prev(q), q, p', next(p), with p' and q' new.
  void split_at_rung(int p, int q);
  // A triangle joins p to the edge q -> next(q): the front then runs prev(p), p, next(q) and q, p',
  // next(p), with p' new.
  void split_at_triangle(int p, int q);
  // Continues with the next layer's nodes.
  void replace(std::vector<FrontNode> nodes) { nodes_ = std::move(nodes); }

  // Nodes in the ring of i; -1 for an open chain, and for a ring of more than `most`.
  int ring_size(int i, int most = std::numeric_limits<int>::max()) const;

 private:
  std::vector<FrontNode> nodes_;
  std::vector<HalfedgeH> idle_edges_;
};

NodeShape node_shape(const SurfaceMesh& mesh, const Front& front, int i);

// `direction` turned by `angle` [rad] counter-clockwise about the unit `normal`.
Vec3 rotated(const Vec3& direction, const Vec3& normal, double angle);

}  // namespace advlayers
