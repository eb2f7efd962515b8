// The room that the layers have left: the core's triangles, and what bounds them.
#pragma once

#include <vector>

#include "measure/core_region.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Inside the room: between two of its triangles, and free to change.
inline bool is_room_edge(const SurfaceMesh& mesh, HalfedgeH h) {
  return is_core_edge(mesh, h) && mesh.is_triangle(h) && mesh.is_triangle(SurfaceMesh::twin(h));
}

// A triangle of the room lies left of the half-edge.
inline bool is_in_room(const SurfaceMesh& mesh, HalfedgeH h) {
  return !mesh.is_border(h) && is_core(mesh, mesh.face(h)) && mesh.is_triangle(h);
}

struct RoomEdge {
  VertexH from, to;
  double weight = 0.0;  // mean of the cotangents opposite: of linear elements
  double area = 0.0;    // of the room's triangles beside it [mm^2]
};

struct CoreRoom {
  std::vector<VertexH> vertices;  // of the core's triangles, in the order of their handles
  std::vector<HalfedgeH> border;  // half-edges of these triangles that stay as they are
  std::vector<char> on_border;    // by VertexH
  std::vector<int> numbers;       // by VertexH: its place in `vertices`; -1: none

  std::size_t number(VertexH v) const { return static_cast<std::size_t>(numbers[v.index()]); }
  std::vector<RoomEdge> edges(const SurfaceMesh& mesh) const;
};

CoreRoom find_core_room(const SurfaceMesh& mesh);

// The half-edge from p of the room's triangle that a direction runs into; invalid where none is.
HalfedgeH room_towards(const SurfaceMesh& mesh, VertexH p, const Vec3& direction);

double distance_to_edge(const SurfaceMesh& mesh, HalfedgeH h, const Vec3& xyz);  // [mm]

}  // namespace advlayers
