#include "mesh/surface_mesh.h"

#include "base/error.h"

namespace advlayers {

VertexH SurfaceMesh::add_vertex(const VertexData& data) {
  const VertexH v(vertex_out_.size());
  vertex_out_.emplace_back();
  vertex_alive_.push_back(1);
  vertex_data_.push_back(data);
  ++live_vertices_;
  return v;
}

HalfedgeH SurfaceMesh::add_edge(VertexH from, VertexH to) {
  HalfedgeH h;
  if (free_edges_.empty()) {
    h = HalfedgeH(to_.size());
    const std::size_t size = to_.size() + 2;
    to_.resize(size);
    next_.resize(size);
    prev_.resize(size);
    face_.resize(size);
    frozen_.push_back(0);
    curve_.emplace_back();
  } else {
    h = free_edges_.back();
    free_edges_.pop_back();
    frozen_[h.index() >> 1] = 0;
    curve_[h.index() >> 1] = EdgeId();
  }
  to_[h.index()] = to;
  to_[h.index() ^ 1] = from;
  face_[h.index()] = face_[h.index() ^ 1] = FaceH();
  ++live_edges_;
  return h;
}

FaceH SurfaceMesh::add_face() {
  ++live_faces_;
  if (!free_faces_.empty()) {
    const FaceH f = free_faces_.back();
    free_faces_.pop_back();
    face_data_[f.index()] = FaceData();
    return f;
  }
  face_halfedge_.emplace_back();
  face_data_.emplace_back();
  return FaceH(face_halfedge_.size() - 1);
}

void SurfaceMesh::link(HalfedgeH a, HalfedgeH b) {
  next_[a.index()] = b;
  prev_[b.index()] = a;
}

void SurfaceMesh::set_triangle(FaceH f, HalfedgeH a, HalfedgeH b, HalfedgeH c) {
  link(a, b);
  link(b, c);
  link(c, a);
  face_[a.index()] = face_[b.index()] = face_[c.index()] = f;
  face_halfedge_[f.index()] = a;
}

void SurfaceMesh::remove_edge(HalfedgeH h) {
  const HalfedgeH first(h.value & ~1);
  to_[first.index()] = to_[first.index() ^ 1] = VertexH();
  free_edges_.push_back(first);
  --live_edges_;
}

void SurfaceMesh::remove_face(FaceH f) {
  face_halfedge_[f.index()] = HalfedgeH();
  free_faces_.push_back(f);
  --live_faces_;
}

void SurfaceMesh::remove_vertex(VertexH v) {
  vertex_alive_[v.index()] = 0;
  vertex_out_[v.index()] = HalfedgeH();
  --live_vertices_;
}

void SurfaceMesh::build(const std::vector<std::vector<VertexH>>& faces) {
  build_of(RunContext(), faces);
}

void SurfaceMesh::build(const RunContext& context, const std::vector<std::vector<VertexH>>& faces) {
  build_of(context, faces);
}

void SurfaceMesh::build_triangles(const RunContext& context,
                                  const std::vector<std::array<VertexH, 3>>& triangles) {
  build_of(context, triangles);
}

SurfaceMesh SurfaceMesh::copy(const RunContext& context) const {
  SurfaceMesh made;
  const auto take = [&](auto member) {
    context.check();  // one of them at a time takes some milliseconds of a large mesh
    made.*member = this->*member;
  };
  take(&SurfaceMesh::to_);
  take(&SurfaceMesh::next_);
  take(&SurfaceMesh::prev_);
  take(&SurfaceMesh::face_);
  take(&SurfaceMesh::frozen_);
  take(&SurfaceMesh::curve_);
  take(&SurfaceMesh::vertex_out_);
  take(&SurfaceMesh::vertex_alive_);
  take(&SurfaceMesh::vertex_data_);
  take(&SurfaceMesh::face_halfedge_);
  take(&SurfaceMesh::face_data_);
  take(&SurfaceMesh::free_edges_);
  take(&SurfaceMesh::free_faces_);
  take(&SurfaceMesh::live_vertices_);
  take(&SurfaceMesh::live_edges_);
  take(&SurfaceMesh::live_faces_);
  return made;
}

template <class Faces>
void SurfaceMesh::build_of(const RunContext& context, const Faces& faces) {
  // Half-edges so far, chained by the vertex they start from: a hash map of all would cost more
  // than the rest of the building.
  std::vector<HalfedgeH> newest(vertex_out_.size()), older(to_.size());
  const auto find = [&](VertexH a, VertexH b) {
    HalfedgeH h = newest[a.index()];
    while (h.valid() && to(h) != b) h = older[h.index()];
    return h;
  };
  const auto chain = [&](HalfedgeH h) {
    older[h.index()] = newest[from(h).index()];
    newest[from(h).index()] = h;
  };
  for (const auto& corners : faces) {
    context.check();
    const FaceH f = add_face();
    HalfedgeH first, last;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexH a = corners[k], b = corners[(k + 1) % corners.size()];
      HalfedgeH h = find(a, b);
      if (!h.valid()) {
        h = add_edge(a, b);
        older.resize(to_.size());
        chain(h);
        chain(twin(h));
      }
      if (face(h).valid()) throw InternalError("two faces on one side of a mesh edge");
      face_[h.index()] = f;
      if (last.valid()) link(last, h);
      if (!first.valid()) first = h;
      last = h;
      vertex_out_[a.index()] = h;
    }
    link(last, first);
    face_halfedge_[f.index()] = first;
  }
  link_border();
  for (std::size_t i = 0; i < vertex_out_.size(); ++i) {
    if (vertex_alive_[i] && !vertex_out_[i].valid()) remove_vertex(VertexH(i));
  }
}

void SurfaceMesh::link_border() {
  std::vector<HalfedgeH> border_out(vertex_out_.size());
  for (std::size_t i = 0; i < to_.size(); ++i) {
    const HalfedgeH h(i);
    if (!alive(h) || !is_border(h)) continue;
    if (border_out[from(h).index()].valid()) {
      throw InternalError("the border touches itself at a mesh vertex");
    }
    border_out[from(h).index()] = h;
  }
  for (std::size_t v = 0; v < border_out.size(); ++v) {
    const HalfedgeH h = border_out[v];
    if (!h.valid()) continue;
    vertex_out_[v] = h;
    link(h, border_out[to(h).index()]);
  }
}

int SurfaceMesh::degree(FaceH f) const {
  int n = 0;
  for ([[maybe_unused]] const HalfedgeH side : sides(f)) ++n;
  return n;
}

int SurfaceMesh::valence(VertexH v) const {
  int n = 0;
  for ([[maybe_unused]] const HalfedgeH spoke : around(v)) ++n;
  return n;
}

HalfedgeH SurfaceMesh::find_halfedge(VertexH a, VertexH b) const {
  const HalfedgeH first = outgoing(a), back = outgoing(b);
  if (!first.valid() || !back.valid()) return {};
  HalfedgeH h = first, t = back;
  // About both ends at once: one of them may have very many edges.
  do {
    if (to(h) == b) return h;
    if (to(t) == a) return twin(t);
    h = rotate_cw(h);
    t = rotate_cw(t);
  } while (h != first && t != back);
  return {};
}

bool SurfaceMesh::is_triangle(HalfedgeH h) const { return next(next(next(h))) == h; }

void SurfaceMesh::add_observer(MeshObserver* observer) { observers_.push_back(observer); }

void SurfaceMesh::remove_observer(MeshObserver* observer) {
  for (auto it = observers_.begin(); it != observers_.end(); ++it) {
    if (*it == observer) {
      observers_.erase(it);
      return;
    }
  }
}

void SurfaceMesh::notify_vertex_created(VertexH v) {
  for (MeshObserver* observer : observers_) observer->vertex_created(*this, v);
}
void SurfaceMesh::notify_face_created(FaceH f) {
  for (MeshObserver* observer : observers_) observer->face_created(*this, f);
}
void SurfaceMesh::notify_face_changed(FaceH f) {
  for (MeshObserver* observer : observers_) observer->face_changed(*this, f);
}

}  // namespace advlayers
