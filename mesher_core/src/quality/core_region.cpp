#include "quality/core_region.h"

namespace advlayers {

bool is_free(const SurfaceMesh& mesh, VertexH v) {
  const VertexData& data = mesh.data(v);
  if (!mesh.alive(v) || data.support != Support::kPatch || data.layer != 0) return false;
  const HalfedgeH first = mesh.outgoing(v);
  if (!first.valid()) return false;
  HalfedgeH h = first;
  do {
    if (mesh.is_border(h) || mesh.frozen(h) || !is_core(mesh, mesh.face(h))) return false;
    h = mesh.rotate_cw(h);
  } while (h != first);
  return true;
}

std::vector<VertexH> free_vertices(const SurfaceMesh& mesh) {
  std::vector<VertexH> free;
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    if (is_free(mesh, VertexH(i))) free.emplace_back(i);
  }
  return free;
}

bool is_core_edge(const SurfaceMesh& mesh, HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  return mesh.alive(h) && !mesh.frozen(h) && !mesh.is_border(h) && !mesh.is_border(t) &&
         is_core(mesh, mesh.face(h)) && is_core(mesh, mesh.face(t));
}

bool is_extrusion(const SurfaceMesh& mesh, HalfedgeH h) {
  return mesh.data(mesh.to(h)).parent == mesh.from(h) ||
         mesh.data(mesh.from(h)).parent == mesh.to(h);
}

void return_to_core(SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f) || is_core(mesh, f) || is_triangle(mesh, mesh.halfedge(f))) continue;
    bool extruded = false;
    HalfedgeH h = mesh.halfedge(f);
    for (int k = 0; k < 4; ++k, h = mesh.next(h)) extruded = extruded || is_extrusion(mesh, h);
    if (!extruded) mesh.data(f).layer = 0;
  }
}

}  // namespace advlayers
