// SurfaceMesh::put_in_order: edges and faces are numbered by their vertices.
#include <algorithm>
#include <tuple>

#include "mesh/surface_mesh.h"

namespace advlayers {
namespace {

template <class Values, class Handle>
Values gathered(const Values& values, const std::vector<Handle>& from) {
  Values result;
  result.reserve(from.size());
  for (const Handle h : from) result.push_back(values[h.index()]);
  return result;
}

// Of edges, which two half-edges share: from[0] and from[1] are those of the first.
template <class Values>
Values gathered_by_edge(const Values& values, const std::vector<HalfedgeH>& from) {
  Values result;
  result.reserve(from.size() / 2);
  for (std::size_t i = 0; i < from.size(); i += 2) result.push_back(values[from[i].index() >> 1]);
  return result;
}

}  // namespace

// Live half-edges in their new order: each edge from its lesser vertex first.
std::vector<HalfedgeH> SurfaceMesh::halfedges_by_vertices(const RunContext& context) const {
  std::vector<HalfedgeH> ahead;
  ahead.reserve(static_cast<std::size_t>(live_edges_));
  for (std::size_t i = 0; i < to_.size(); i += 2) {
    const HalfedgeH h(i);
    if (alive(h)) ahead.push_back(from(h) < to(h) ? h : twin(h));
  }
  const auto ends = [this](HalfedgeH h) { return std::make_tuple(from(h), to(h)); };
  std::sort(ahead.begin(), ahead.end(), [&](HalfedgeH a, HalfedgeH b) {
    context.check();
    return ends(a) < ends(b);
  });
  std::vector<HalfedgeH> order;
  order.reserve(2 * ahead.size());
  for (const HalfedgeH h : ahead) order.insert(order.end(), {h, twin(h)});
  return order;
}

HalfedgeH SurfaceMesh::from_least_corner(FaceH f) const {
  HalfedgeH least = halfedge(f);
  for (const HalfedgeH h : sides(f)) {
    if (from(h) < from(least)) least = h;
  }
  return least;
}

void SurfaceMesh::put_in_order(const RunContext& context) {
  const std::vector<HalfedgeH> halves = halfedges_by_vertices(context);
  std::vector<HalfedgeH> corners;  // one half-edge of each live face
  corners.reserve(static_cast<std::size_t>(live_faces_));
  for (std::size_t i = 0; i < face_halfedge_.size(); ++i) {
    if (alive(FaceH(i))) corners.push_back(from_least_corner(FaceH(i)));
  }
  const auto ends = [this](HalfedgeH h) { return std::make_tuple(from(h), to(h)); };
  std::sort(corners.begin(), corners.end(), [&](HalfedgeH a, HalfedgeH b) {
    context.check();
    return ends(a) < ends(b);
  });

  std::vector<HalfedgeH> half_to(to_.size());
  for (std::size_t k = 0; k < halves.size(); ++k) half_to[halves[k].index()] = HalfedgeH(k);
  std::vector<FaceH> face_to(face_halfedge_.size()), faces;
  faces.reserve(corners.size());
  for (const HalfedgeH h : corners) {
    face_to[face(h).index()] = FaceH(faces.size());
    faces.push_back(face(h));
  }
  to_ = gathered(to_, halves);
  next_ = gathered(next_, halves);
  prev_ = gathered(prev_, halves);
  face_ = gathered(face_, halves);
  for (HalfedgeH& h : next_) h = half_to[h.index()];
  for (HalfedgeH& h : prev_) h = half_to[h.index()];
  for (FaceH& f : face_) f = f.valid() ? face_to[f.index()] : f;
  frozen_ = gathered_by_edge(frozen_, halves);
  curve_ = gathered_by_edge(curve_, halves);
  face_data_ = gathered(face_data_, faces);
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
