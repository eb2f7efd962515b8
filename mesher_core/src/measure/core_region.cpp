#include "measure/core_region.h"

namespace advlayers {
namespace {

// The first layers are what the user asked for; where their vertices are regular they stay.
constexpr int kKeptLayers = 5;

}  // namespace

bool is_free(const SurfaceMesh& mesh, VertexH v) {
  const VertexData& data = mesh.data(v);
  if (!mesh.alive(v) || data.support != Support::kPatch || data.layer != 0) return false;
  if (!mesh.outgoing(v).valid()) return false;
  for (const HalfedgeH h : mesh.around(v)) {
    if (mesh.is_border(h) || mesh.frozen(h) || !is_core(mesh, mesh.face(h))) return false;
  }
  return true;
}

std::vector<VertexH> free_vertices(const SurfaceMesh& mesh) {
  std::vector<VertexH> free;
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    if (is_free(mesh, VertexH(i))) free.emplace_back(i);
  }
  return free;
}

std::vector<VertexH> seam_vertices(const SurfaceMesh& mesh) {
  std::vector<char> in_seam(mesh.vertex_capacity(), 0);
  std::vector<VertexH> corners;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f) || !is_core(mesh, f)) continue;
    corners.clear();
    bool any_free = false;
    for (const HalfedgeH h : mesh.sides(f)) {
      corners.push_back(mesh.to(h));
      any_free = any_free || is_free(mesh, mesh.to(h));
    }
    if (any_free) continue;
    for (const VertexH v : corners) {
      const VertexData& data = mesh.data(v);
      if (data.support == Support::kPatch && data.layer > kKeptLayers) in_seam[v.index()] = 1;
    }
  }
  std::vector<VertexH> seam;
  for (std::size_t i = 0; i < in_seam.size(); ++i) {
    if (in_seam[i]) seam.emplace_back(i);
  }
  return seam;
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
    if (!mesh.alive(f) || is_core(mesh, f) || mesh.is_triangle(mesh.halfedge(f))) continue;
    bool extruded = false;
    for (const HalfedgeH h : mesh.sides(f)) extruded = extruded || is_extrusion(mesh, h);
    if (!extruded) mesh.data(f).layer = 0;
  }
}

}  // namespace advlayers
