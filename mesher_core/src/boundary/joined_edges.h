// Edges that part from each other only beyond their tolerance: up to there they are one line.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/evaluator.h"

namespace advlayers {

// Two edges of one loop of a face that leave a vertex together, as the sides of a fillet that
// vanishes do.
struct JoinedEnds {
  struct End {
    EdgeId edge;
    double t_vertex, t_parting;  // parameters at the vertex and where the edges part
  };
  End kept, other;  // `other` gets the nodes of `kept` between them
  // Where `kept` ends there; then `other` goes on from that vertex. Else a node is made.
  VertexId parting_vertex;
};

// Only those are found that go together for as long as `least` [mm], so that no corner is cut off
// that a mesh edge could show, and each edge with one other at each of its ends at most.
class JoinedEdges {
 public:
  JoinedEdges() = default;
  JoinedEdges(const RunContext& context, Evaluator& evaluator,
              const std::vector<bool>& meshed_faces,
              const std::vector<double>& least);  // [mm] by EdgeId

  // Parameters at which the edge must have a node.
  void add_joints(std::vector<std::vector<double>>& joints) const;
  // The edges' common node at a parameter that add_joints gave: its number among the partings, or
  // the vertex; -1, and none, for other parameters.
  int parting_at(EdgeId edge, double t, VertexId& vertex) const;
  std::size_t size() const { return ends_.size(); }
  // Gives one edge of each pair the nodes of the other.
  void share_nodes(Evaluator& evaluator, Discretization& out) const;

 private:
  std::vector<JoinedEnds> ends_;
};

}  // namespace advlayers
