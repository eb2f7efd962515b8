// The local operations of SurfaceMesh: for each a question, and the act.
#include "mesh/surface_mesh.h"

#include "base/error.h"

namespace advlayers {

VertexH SurfaceMesh::split_face(FaceH f, const VertexData& data) {
  const HalfedgeH ab = halfedge(f), bc = next(ab), ca = next(bc);
  const VertexH a = from(ab), b = to(ab), c = to(bc);
  const VertexH v = add_vertex(data);
  const HalfedgeH av = add_edge(a, v), bv = add_edge(b, v), cv = add_edge(c, v);
  const FaceData face_data = face_data_[f.index()];
  const FaceH f1 = add_face(), f2 = add_face();
  face_data_[f1.index()] = face_data_[f2.index()] = face_data;
  set_triangle(f, ab, bv, twin(av));
  set_triangle(f1, bc, cv, twin(bv));
  set_triangle(f2, ca, av, twin(cv));
  vertex_out_[v.index()] = twin(av);
  notify_vertex_created(v);
  notify_face_changed(f);
  notify_face_created(f1);
  notify_face_created(f2);
  return v;
}

Veto SurfaceMesh::split_edge_veto(HalfedgeH h) const {
  if (frozen(h)) return Veto::kFrozen;
  for (const HalfedgeH side : {h, twin(h)}) {
    if (!is_border(side) && !is_triangle(side)) return Veto::kNotTriangles;
  }
  return Veto::kNone;
}

VertexH SurfaceMesh::split_edge(HalfedgeH h, const VertexData& data) {
  const HalfedgeH t = twin(h);
  const VertexH b = to(h);
  const HalfedgeH hn = next(h), hp = prev(h), tn = next(t), tp = prev(t);
  const VertexH v = add_vertex(data);
  const HalfedgeH vb = add_edge(v, b);
  to_[h.index()] = v;
  if (outgoing(b) == t) vertex_out_[b.index()] = twin(vb);
  std::array<FaceH, 2> made{};
  if (!is_border(h)) {
    const FaceH f = face(h);
    const HalfedgeH vc = add_edge(v, to(hn));
    made[0] = add_face();
    face_data_[made[0].index()] = face_data_[f.index()];
    set_triangle(f, h, vc, hp);
    set_triangle(made[0], vb, hn, twin(vc));
  } else {
    link(h, vb);
    link(vb, hn);
  }
  if (!is_border(t)) {
    const FaceH f = face(t);
    const HalfedgeH vd = add_edge(v, to(tn));
    made[1] = add_face();
    face_data_[made[1].index()] = face_data_[f.index()];
    set_triangle(f, t, tn, twin(vd));
    set_triangle(made[1], twin(vb), vd, tp);
  } else {
    link(tp, twin(vb));
    link(twin(vb), t);
  }
  vertex_out_[v.index()] = is_border(t) ? t : vb;
  notify_vertex_created(v);
  for (const HalfedgeH side : {h, t}) {
    if (!is_border(side)) notify_face_changed(face(side));
  }
  for (const FaceH f : made) {
    if (f.valid()) notify_face_created(f);
  }
  return v;
}

Veto SurfaceMesh::flip_veto(HalfedgeH h) const {
  if (frozen(h)) return Veto::kFrozen;
  if (is_border(h) || is_border(twin(h))) return Veto::kBorder;
  if (!is_triangle(h) || !is_triangle(twin(h))) return Veto::kNotTriangles;
  if (find_halfedge(to(next(h)), to(next(twin(h)))).valid()) return Veto::kEdgeExists;
  return Veto::kNone;
}

void SurfaceMesh::flip(HalfedgeH h) {
  const HalfedgeH t = twin(h);
  const HalfedgeH hn = next(h), hp = prev(h), tn = next(t), tp = prev(t);
  const VertexH a = from(h), b = to(h), c = to(hn), d = to(tn);
  const FaceH f = face(h), g = face(t);
  if (outgoing(a) == h) vertex_out_[a.index()] = tn;
  if (outgoing(b) == t) vertex_out_[b.index()] = hn;
  to_[h.index()] = c;
  to_[t.index()] = d;
  set_triangle(f, h, hp, tn);
  set_triangle(g, t, tp, hn);
  notify_face_changed(f);
  notify_face_changed(g);
}

Veto SurfaceMesh::collapse_veto(HalfedgeH h) const {
  if (frozen(h)) return Veto::kFrozen;
  const HalfedgeH t = twin(h);
  const VertexH a = from(h), b = to(h);
  if (is_border(a) || is_border(h) || is_border(t)) return Veto::kBorder;
  if (!is_triangle(h) || !is_triangle(t)) return Veto::kNotTriangles;
  const HalfedgeH hn = next(h), hp = prev(h), tn = next(t), tp = prev(t);
  if (frozen(hn) && frozen(hp)) return Veto::kFrozen;
  if (frozen(tn) && frozen(tp)) return Veto::kFrozen;
  const VertexH c = to(hn), d = to(tn);
  for (const VertexH apex : {c, d}) {
    if (valence(apex) <= (is_border(apex) ? 2 : 3)) return Veto::kLink;
  }
  // No face but the two beside h may hold both ends, and they share no neighbour but c and d.
  for (const HalfedgeH o : around(h)) {
    if (o == h) continue;
    const VertexH w = to(o);
    if (w != c && w != d && find_halfedge(w, b).valid()) return Veto::kLink;
    if (!is_triangle(o) && to(next(o)) == b && o != t) return Veto::kLink;
  }
  return Veto::kNone;
}

void SurfaceMesh::collapse(HalfedgeH h) {
  const HalfedgeH t = twin(h);
  const VertexH a = from(h), b = to(h);
  const HalfedgeH hn = next(h), hp = prev(h), tn = next(t), tp = prev(t);
  const FaceH f = face(h), g = face(t);
  const VertexH c = to(hn), d = to(tn);
  for (const HalfedgeH o : around(h)) to_[twin(o).index()] = b;
  // The kept edge (b, c) takes the place of (a, c) in the face beyond it; likewise (d, b).
  merge_edges(hn, twin(hp));
  merge_edges(tp, twin(tn));
  if (outgoing(b) == t || outgoing(b) == twin(hp) || !alive(outgoing(b)))
    vertex_out_[b.index()] = hn;
  if (outgoing(c) == hp) vertex_out_[c.index()] = twin(hn);
  if (outgoing(d) == twin(tn)) vertex_out_[d.index()] = tp;
  remove_edge(hp);
  remove_edge(tn);
  remove_edge(h);
  remove_face(f);
  remove_face(g);
  remove_vertex(a);
  for (MeshObserver* observer : observers_) {
    observer->vertex_deleted(*this, a);
    observer->face_deleted(*this, f);
    observer->face_deleted(*this, g);
  }
  if (!observers_.empty()) {
    for (const HalfedgeH o : around(b)) {
      if (!is_border(o)) notify_face_changed(face(o));
    }
  }
}

void SurfaceMesh::merge_edges(HalfedgeH kept, HalfedgeH gone) {
  link(prev(gone), kept);
  link(kept, next(gone));
  const FaceH f = face(gone);
  face_[kept.index()] = f;
  if (f.valid() && halfedge(f) == gone) face_halfedge_[f.index()] = kept;
  if (frozen(gone)) set_frozen(kept, true);
  if (curve(gone).valid()) set_curve(kept, curve(gone));
}

Veto SurfaceMesh::combine_veto(HalfedgeH h) const {
  if (frozen(h)) return Veto::kFrozen;
  if (is_border(h) || is_border(twin(h))) return Veto::kBorder;
  if (!is_triangle(h) || !is_triangle(twin(h))) return Veto::kNotTriangles;
  // A vertex with two edges would be left inside a single quad corner.
  for (const HalfedgeH side : {h, twin(h)}) {
    if (valence(from(side)) <= (is_border(from(side)) ? 2 : 3)) return Veto::kLink;
  }
  return Veto::kNone;
}

FaceH SurfaceMesh::combine(HalfedgeH h) {
  const HalfedgeH t = twin(h);
  const HalfedgeH hn = next(h), hp = prev(h), tn = next(t), tp = prev(t);
  const FaceH f = face(h), g = face(t);
  const VertexH a = from(h), b = to(h);
  link(hp, tn);
  link(tp, hn);
  face_[tn.index()] = face_[tp.index()] = f;
  face_halfedge_[f.index()] = hn;
  if (outgoing(a) == h) vertex_out_[a.index()] = tn;
  if (outgoing(b) == t) vertex_out_[b.index()] = hn;
  remove_edge(h);
  remove_face(g);
  for (MeshObserver* observer : observers_) observer->face_deleted(*this, g);
  notify_face_changed(f);
  return f;
}

HalfedgeH SurfaceMesh::divide(FaceH quad, VertexH v) {
  HalfedgeH va = halfedge(quad);
  for (int k = 0; k < 4 && from(va) != v; ++k) va = next(va);
  if (from(va) != v || is_triangle(va)) throw InternalError("divide: no quad with this corner");
  const HalfedgeH ac = next(va), cb = next(ac), bv = next(cb);
  const VertexH c = to(ac);
  const HalfedgeH vc = add_edge(v, c);
  const FaceH made = add_face();
  face_data_[made.index()] = face_data_[quad.index()];
  set_triangle(quad, va, ac, twin(vc));
  set_triangle(made, vc, cb, bv);
  notify_face_changed(quad);
  notify_face_created(made);
  return vc;
}

}  // namespace advlayers
