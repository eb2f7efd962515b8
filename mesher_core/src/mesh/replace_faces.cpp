// SurfaceMesh::replace: discs are small, so that plain lists serve as sets.
#include <algorithm>

#include "base/error.h"
#include "mesh/surface_mesh.h"

namespace advlayers {
namespace {

template <class T>
bool contains(const std::vector<T>& list, const T& item) {
  return std::find(list.begin(), list.end(), item) != list.end();
}

// The half-edges inside a disc: those along its loop, and one of each edge within.
struct Disc {
  std::vector<HalfedgeH> loop, within;

  Disc(const SurfaceMesh& mesh, const std::vector<FaceH>& faces) {
    for (const FaceH f : faces) {
      for (const HalfedgeH h : mesh.sides(f)) {
        const HalfedgeH t = SurfaceMesh::twin(h);
        if (mesh.is_border(t) || !contains(faces, mesh.face(t))) {
          loop.push_back(h);
        } else if (h.value < t.value) {
          within.push_back(h);
        }
      }
    }
  }
};

HalfedgeH find_between(const SurfaceMesh& mesh, const std::vector<HalfedgeH>& edges, VertexH a,
                       VertexH b) {
  for (const HalfedgeH h : edges) {
    if (mesh.from(h) == a && mesh.to(h) == b) return h;
  }
  return {};
}

}  // namespace

Veto SurfaceMesh::replace_veto(const std::vector<FaceH>& old,
                               const std::vector<std::vector<VertexH>>& faces) const {
  const Disc disc(*this, old);
  std::vector<VertexH> chord_ends;
  for (const auto& corners : faces) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexH a = corners[k], b = corners[(k + 1) % corners.size()];
      if (find_between(*this, disc.loop, a, b).valid()) continue;
      chord_ends.push_back(a);
      HalfedgeH there = find_halfedge(a, b);
      if (there.valid() && there.value > twin(there).value) there = twin(there);
      if (there.valid() && !contains(disc.within, there)) return Veto::kEdgeExists;
    }
  }
  // A vertex with two edges would be left inside a single corner.
  for (const HalfedgeH h : disc.loop) {
    const VertexH v = from(h);
    if (is_border(v) || contains(chord_ends, v)) continue;
    const HalfedgeH outside = twin(h);  // towards v
    if (find_between(*this, disc.loop, to(next(outside)), v).valid()) return Veto::kLink;
  }
  return Veto::kNone;
}

std::vector<FaceH> SurfaceMesh::replace(const std::vector<FaceH>& old,
                                        const std::vector<std::vector<VertexH>>& faces) {
  const Disc disc(*this, old);
  std::vector<VertexH> inside;
  for (const HalfedgeH h : disc.within) {
    for (const VertexH v : {from(h), to(h)}) {
      if (!contains(inside, v)) inside.push_back(v);
    }
  }
  for (const HalfedgeH h : disc.loop) {
    inside.erase(std::remove(inside.begin(), inside.end(), from(h)), inside.end());
    if (!is_border(from(h))) vertex_out_[from(h).index()] = h;
  }
  for (const HalfedgeH h : disc.within) remove_edge(h);
  for (const FaceH f : old) {
    remove_face(f);
    for (MeshObserver* observer : observers_) observer->face_deleted(*this, f);
  }
  std::vector<HalfedgeH> open = disc.loop;
  std::vector<FaceH> made;
  for (const auto& corners : faces) {
    const FaceH f = made.emplace_back(add_face());
    std::vector<HalfedgeH> sides;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexH a = corners[k], b = corners[(k + 1) % corners.size()];
      HalfedgeH h = find_between(*this, open, a, b);
      if (!h.valid()) {
        h = add_edge(a, b);
        open.push_back(twin(h));
      }
      face_[h.index()] = f;
      if (contains(inside, a)) vertex_out_[a.index()] = h;
      sides.push_back(h);
    }
    for (std::size_t k = 0; k < sides.size(); ++k) link(sides[k], sides[(k + 1) % sides.size()]);
    face_halfedge_[f.index()] = sides.front();
  }
  for (const VertexH v : inside) {
    if (alive(outgoing(v)) && from(outgoing(v)) == v && contains(made, face(outgoing(v)))) continue;
    remove_vertex(v);
    for (MeshObserver* observer : observers_) observer->vertex_deleted(*this, v);
  }
  for (const FaceH f : made) notify_face_created(f);
  return made;
}

}  // namespace advlayers
