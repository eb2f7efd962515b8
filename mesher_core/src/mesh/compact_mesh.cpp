// SurfaceMesh::compact: tombstones go, and everything is numbered anew in its old order.
#include "mesh/surface_mesh.h"

namespace advlayers {
namespace {

// New index of each entry that stays, in order.
template <class Handle, class Keep>
std::vector<Handle> renumber(std::size_t size, Keep keep) {
  std::vector<Handle> to(size);
  std::size_t n = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (keep(Handle(i))) to[i] = Handle(n++);
  }
  return to;
}

}  // namespace

void SurfaceMesh::compact() {
  const auto vertex_to = renumber<VertexH>(vertex_out_.size(), [&](VertexH v) { return alive(v); });
  const auto half_to = renumber<HalfedgeH>(to_.size(), [&](HalfedgeH h) { return alive(h); });
  const auto face_to = renumber<FaceH>(face_halfedge_.size(), [&](FaceH f) { return alive(f); });
  const auto moved = [](auto handle, const auto& map) {
    return handle.valid() ? map[handle.index()] : handle;
  };
  for (std::size_t i = 0; i < half_to.size(); ++i) {
    if (!half_to[i].valid()) continue;
    const std::size_t k = half_to[i].index();
    to_[k] = moved(to_[i], vertex_to);
    next_[k] = moved(next_[i], half_to);
    prev_[k] = moved(prev_[i], half_to);
    face_[k] = moved(face_[i], face_to);
    frozen_[k >> 1] = frozen_[i >> 1];
    curve_[k >> 1] = curve_[i >> 1];
  }
  for (std::size_t i = 0; i < vertex_to.size(); ++i) {
    if (!vertex_to[i].valid()) continue;
    const std::size_t k = vertex_to[i].index();
    vertex_out_[k] = moved(vertex_out_[i], half_to);
    vertex_data_[k] = vertex_data_[i];
    vertex_data_[k].parent = moved(vertex_data_[k].parent, vertex_to);
  }
  for (std::size_t i = 0; i < face_to.size(); ++i) {
    if (!face_to[i].valid()) continue;
    face_halfedge_[face_to[i].index()] = moved(face_halfedge_[i], half_to);
    face_data_[face_to[i].index()] = face_data_[i];
  }
  const auto edges = static_cast<std::size_t>(live_edges_);
  to_.resize(2 * edges);
  next_.resize(2 * edges);
  prev_.resize(2 * edges);
  face_.resize(2 * edges);
  frozen_.resize(edges);
  curve_.resize(edges);
  vertex_out_.resize(static_cast<std::size_t>(live_vertices_));
  vertex_data_.resize(static_cast<std::size_t>(live_vertices_));
  vertex_alive_.assign(static_cast<std::size_t>(live_vertices_), 1);
  face_halfedge_.resize(static_cast<std::size_t>(live_faces_));
  face_data_.resize(static_cast<std::size_t>(live_faces_));
  free_edges_.clear();
  free_faces_.clear();
}

}  // namespace advlayers
