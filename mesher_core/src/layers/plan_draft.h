// The plan of a layer while it is made, and what its steps share (see layer_plan.h).
#pragma once

#include <vector>

#include "layers/layer_plan.h"
#include "layers/opposing_fronts.h"
#include "mesh/triangle_measures.h"

namespace advlayers {

// A layer that ends beside one this many heights long closes with a triangle; the side of a shorter
// one is no worse an edge for the core.
inline constexpr double kStepAspect = 20.0;

class PlanDraft {
 public:
  explicit PlanDraft(LayerState& layer_state);

  LayerState& state;
  SurfaceMesh& mesh;
  Front& front;
  LayerPlan plan;
  std::vector<double> heights;  // of this extrusion, by front node [mm]
  std::vector<Opposite> opposites;
  std::vector<Cell> tops;  // over the treads, made after all other cells

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const NodeShape& shape(int i) const { return plan.shapes[index(i)]; }
  bool advances(int i) const { return front[i].active; }
  const Vec3& position(int i) const { return mesh.position(front[i].vertex); }
  double height(int i) const { return heights[index(i)]; }
  Kid& kid(int k) { return plan.kids[index(k)]; }
  const Kid& kid(int k) const { return plan.kids[index(k)]; }
  std::vector<int>& kids_of(int i) { return plan.kids_of[index(i)]; }
  const std::vector<int>& kids_of(int i) const { return plan.kids_of[index(i)]; }

  // The node stops; neighbours that go on close the layer beside it with a triangle, and stop
  // themselves a layer later, so that neighbouring columns differ by one layer at most.
  void end(int i, Stop reason);
  // A column without neighbours would stand alone.
  void drop_lone_nodes(Stop reason);

  int add_kid(int node, const SurfacePoint& point);
  // A kid `length` [mm] along the surface; -1 where the surface ends.
  int step_kid(int node, const Vec3& direction, double length);
  void drop_kids_of(int i);

  // The end edge of a strip, between two corners.
  bool is_strip_end(int i, int k) const;

  Corner corner_of(const CellCorner& c) const;
  // Every corner of the planned cell is convex, and no angle next to nothing.
  bool convex(const Cell& cell) const;
};

}  // namespace advlayers
