// SurfaceMesh::put_in_order: edges and faces are numbered by their vertices.
#include <algorithm>
#include <tuple>

#include "mesh/surface_mesh.h"

namespace advlayers {
namespace {

template <class Values>
Values gathered(const Values& values, const std::vector<std::size_t>& from) {
  Values result;
  result.reserve(from.size());
  for (const std::size_t i : from) result.push_back(values[i]);
  return result;
}

}  // namespace

// Live half-edges in their new order: each edge from its lesser vertex first.
std::vector<HalfedgeH> SurfaceMesh::halfedges_by_vertices() const {
  std::vector<HalfedgeH> ahead;
  for (std::size_t i = 0; i < to_.size(); i += 2) {
    const HalfedgeH h(i);
    if (alive(h)) ahead.push_back(from(h) < to(h) ? h : twin(h));
  }
  const auto ends = [this](HalfedgeH h) { return std::make_tuple(from(h), to(h)); };
  std::sort(ahead.begin(), ahead.end(),
            [&](HalfedgeH a, HalfedgeH b) { return ends(a) < ends(b); });
  std::vector<HalfedgeH> order;
  order.reserve(2 * ahead.size());
  for (const HalfedgeH h : ahead) order.insert(order.end(), {h, twin(h)});
  return order;
}

HalfedgeH SurfaceMesh::from_least_corner(FaceH f) const {
  HalfedgeH least = halfedge(f);
  for (HalfedgeH h = next(least); h != halfedge(f); h = next(h)) {
    if (from(h) < from(least)) least = h;
  }
  return least;
}

void SurfaceMesh::put_in_order() {
  const std::vector<HalfedgeH> halves = halfedges_by_vertices();
  std::vector<HalfedgeH> corners;  // one half-edge of each live face
  for (std::size_t i = 0; i < face_halfedge_.size(); ++i) {
    if (alive(FaceH(i))) corners.push_back(from_least_corner(FaceH(i)));
  }
  const auto ends = [this](HalfedgeH h) { return std::make_tuple(from(h), to(h)); };
  std::sort(corners.begin(), corners.end(),
            [&](HalfedgeH a, HalfedgeH b) { return ends(a) < ends(b); });

  std::vector<HalfedgeH> half_to(to_.size());
  std::vector<std::size_t> half_from, edge_from, face_from;
  for (const HalfedgeH h : halves) {
    half_to[h.index()] = HalfedgeH(half_from.size());
    half_from.push_back(h.index());
    if (half_from.size() % 2 == 0) edge_from.push_back(h.index() >> 1);
  }
  std::vector<FaceH> face_to(face_halfedge_.size());
  for (const HalfedgeH h : corners) {
    face_to[face(h).index()] = FaceH(face_from.size());
    face_from.push_back(face(h).index());
  }
  to_ = gathered(to_, half_from);
  next_ = gathered(next_, half_from);
  prev_ = gathered(prev_, half_from);
  face_ = gathered(face_, half_from);
  for (HalfedgeH& h : next_) h = half_to[h.index()];
  for (HalfedgeH& h : prev_) h = half_to[h.index()];
  for (FaceH& f : face_) f = f.valid() ? face_to[f.index()] : f;
  frozen_ = gathered(frozen_, edge_from);
  curve_ = gathered(curve_, edge_from);
  face_data_ = gathered(face_data_, face_from);
  face_halfedge_.resize(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) face_halfedge_[k] = half_to[corners[k].index()];
  free_edges_.clear();
  free_faces_.clear();
  set_outgoing();
}

// The border half-edge of each vertex, where it has one, or the least that leaves it.
void SurfaceMesh::set_outgoing() {
  std::fill(vertex_out_.begin(), vertex_out_.end(), HalfedgeH());
  for (std::size_t i = 0; i < to_.size(); ++i) {
    HalfedgeH& out = vertex_out_[from(HalfedgeH(i)).index()];
    if (!out.valid() || is_border(HalfedgeH(i))) out = HalfedgeH(i);
  }
}

}  // namespace advlayers
