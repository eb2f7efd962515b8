#include "core/core_room.h"

#include <algorithm>

namespace advlayers {
namespace {

// Of an edge, where the cotangents give less: the field is to stay a mean of its neighbours.
constexpr double kLeastWeight = 1e-3;
constexpr double kAlong = 1e-9;  // sine of an angle that is none

}  // namespace

std::vector<RoomEdge> CoreRoom::edges(const SurfaceMesh& mesh) const {
  std::vector<RoomEdge> edges;
  for (std::size_t e = 0; e < mesh.halfedge_capacity(); e += 2) {
    const HalfedgeH h(e);
    if (!mesh.alive(h)) continue;
    RoomEdge edge{mesh.from(h), mesh.to(h)};
    bool any = false;
    for (const HalfedgeH side : {h, SurfaceMesh::twin(h)}) {
      if (!is_in_room(mesh, side)) continue;
      any = true;
      const Vec3& apex = mesh.position(mesh.to(mesh.next(side)));
      const Vec3 a = mesh.position(mesh.from(side)) - apex;
      const Vec3 b = mesh.position(mesh.to(side)) - apex;
      const double area2 = std::max(a.cross(b).norm(), 1e-300);
      edge.weight += 0.5 * a.dot(b) / area2;
      edge.area += 0.5 * area2;
    }
    if (!any) continue;
    edge.weight = std::max(edge.weight, kLeastWeight);
    edges.push_back(edge);
  }
  return edges;
}

CoreRoom find_core_room(const SurfaceMesh& mesh) {
  CoreRoom room;
  room.on_border.assign(mesh.vertex_capacity(), 0);
  room.numbers.assign(mesh.vertex_capacity(), -1);
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f) || !is_in_room(mesh, mesh.halfedge(f))) continue;
    HalfedgeH h = mesh.halfedge(f);
    for (int k = 0; k < 3; ++k, h = mesh.next(h)) {
      room.numbers[mesh.to(h).index()] = 0;
      if (!is_room_edge(mesh, h)) room.border.push_back(h);
    }
  }
  for (std::size_t i = 0; i < room.numbers.size(); ++i) {
    if (room.numbers[i] < 0) continue;
    room.numbers[i] = static_cast<int>(room.vertices.size());
    room.vertices.emplace_back(i);
    room.on_border[i] = !is_free(mesh, VertexH(i));
  }
  return room;
}

HalfedgeH room_towards(const SurfaceMesh& mesh, VertexH p, const Vec3& direction) {
  const Vec3& normal = mesh.data(p).normal;
  const HalfedgeH first = mesh.outgoing(p);
  HalfedgeH h = first;
  do {
    if (is_in_room(mesh, h)) {
      const Vec3 b = mesh.position(mesh.to(h)) - mesh.position(p);
      const Vec3 c = mesh.position(mesh.from(mesh.prev(h))) - mesh.position(p);
      // Along an edge: always into the triangle on its left.
      const double along = kAlong * direction.norm();
      if (b.cross(direction).dot(normal) >= -along * b.norm() &&
          direction.cross(c).dot(normal) > along * c.norm()) {
        return h;
      }
    }
    h = mesh.rotate_ccw(h);
  } while (h != first);
  return {};
}

double distance_to_edge(const SurfaceMesh& mesh, HalfedgeH h, const Vec3& xyz) {
  const Vec3& a = mesh.position(mesh.from(h));
  const Vec3 ab = mesh.position(mesh.to(h)) - a;
  const double share = std::clamp((xyz - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
  return (a + share * ab - xyz).norm();
}

}  // namespace advlayers
