// A plain cut of all edges: equal lengths, by size and the angle a segment may turn. For tests of
// what comes after the boundary.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "boundary/discretization.h"

namespace advlayers::test {

inline int segments_of(Evaluator& evaluator, EdgeId id, double size, double angle) {
  const Edge& edge = evaluator.model().edge(id);
  constexpr int kSamples = 64;
  double turn = 0;
  Vec3 last = evaluator.edge_tangent(id, edge.first);
  for (int k = 1; k <= kSamples; ++k) {
    const Vec3 tangent =
        evaluator.edge_tangent(id, edge.first + (edge.last - edge.first) * k / kSamples);
    turn += std::atan2(last.cross(tangent).norm(), last.dot(tangent));
    last = tangent;
  }
  const int least = edge.start == edge.end ? 3 : 1;
  return std::max({least, static_cast<int>(std::ceil(edge.length / size - 1e-6)),
                   static_cast<int>(std::ceil(turn / angle - 1e-6))});
}

inline Discretization cut_edges(Evaluator& evaluator, double size, double angle_degrees = 20) {
  const Model& model = evaluator.model();
  Discretization cut;
  cut.edges.resize(model.edges().size());
  std::map<VertexId, NodeId> node_of_vertex;
  const auto vertex_node = [&](VertexId v, EdgeId e, double t) {
    if (const auto found = node_of_vertex.find(v); v.valid() && found != node_of_vertex.end()) {
      return found->second;
    }
    BoundaryNode node;
    node.vertex = v;
    node.edge = v.valid() ? EdgeId() : e;
    node.t = t;
    node.xyz = v.valid() ? model.vertex(v).xyz : evaluator.edge_point(e, t);
    cut.nodes.push_back(node);
    const NodeId id(cut.nodes.size() - 1);
    if (v.valid()) node_of_vertex[v] = id;
    return id;
  };
  for (std::size_t i = 0; i < model.edges().size(); ++i) {
    const EdgeId id(i);
    const Edge& edge = model.edge(id);
    EdgeNodes& nodes = cut.edges[i];
    nodes.nodes.push_back(vertex_node(edge.start, id, edge.first));
    nodes.params.push_back(edge.first);
    if (edge.degenerate) continue;
    const int n = segments_of(evaluator, id, size, angle_degrees * M_PI / 180);
    for (int k = 1; k < n; ++k) {
      const double t = evaluator.edge_parameter(id, edge.first, edge.length * k / n);
      cut.nodes.push_back({evaluator.edge_point(id, t), VertexId(), id, t});
      nodes.nodes.push_back(NodeId(cut.nodes.size() - 1));
      nodes.params.push_back(t);
    }
    const bool closed = edge.start == edge.end;
    nodes.nodes.push_back(closed ? nodes.nodes.front() : vertex_node(edge.end, id, edge.last));
    nodes.params.push_back(edge.last);
  }
  return cut;
}

}  // namespace advlayers::test
