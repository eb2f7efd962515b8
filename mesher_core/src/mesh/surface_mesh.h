// A half-edge mesh of triangles and quads on a surface. Structure of arrays, twin = h ^ 1, typed
// 32-bit handles, tombstones for what was removed. Topology only decides here what is legal;
// whether an operation is geometrically sound is asked in layers/ and triangulate/.
//
// Orientation: a face's half-edges run counter-clockwise against the outward normal. A half-edge
// whose face is invalid bounds a hole: its `next` runs along the hole's border.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/run_context.h"
#include "base/types.h"
#include "mesh/mesh_observer.h"
#include "mesh/mesh_types.h"
#include "mesh/ring.h"

namespace advlayers {

class SurfaceMesh {
 public:
  // --- building ---
  VertexH add_vertex(const VertexData& data);
  // Makes all faces at once from vertex lists (3 or 4 indices, counter-clockwise). Vertices of no
  // face vanish.
  // Throws InternalError where the result is no manifold with border; with a context, Cancelled.
  void build(const std::vector<std::vector<VertexH>>& faces);  // few of them
  void build(const RunContext& context, const std::vector<std::vector<VertexH>>& faces);
  void build_triangles(const RunContext& context,
                       const std::vector<std::array<VertexH, 3>>& triangles);
  // The same mesh, without its observers. Throws Cancelled.
  SurfaceMesh copy(const RunContext& context) const;

  // --- sizes: capacities count tombstones, live counts do not ---
  std::size_t vertex_capacity() const { return vertex_out_.size(); }
  std::size_t halfedge_capacity() const { return to_.size(); }
  std::size_t face_capacity() const { return face_halfedge_.size(); }
  int vertex_count() const { return live_vertices_; }
  int edge_count() const { return live_edges_; }
  int face_count() const { return live_faces_; }
  bool alive(VertexH v) const { return vertex_alive_[v.index()] != 0; }
  bool alive(FaceH f) const { return face_halfedge_[f.index()].valid(); }
  bool alive(HalfedgeH h) const { return to_[h.index()].valid(); }

  // --- navigation ---
  static HalfedgeH twin(HalfedgeH h) { return HalfedgeH(h.value ^ 1); }
  HalfedgeH next(HalfedgeH h) const { return next_[h.index()]; }
  HalfedgeH prev(HalfedgeH h) const { return prev_[h.index()]; }
  VertexH to(HalfedgeH h) const { return to_[h.index()]; }
  VertexH from(HalfedgeH h) const { return to_[h.index() ^ 1]; }
  FaceH face(HalfedgeH h) const { return face_[h.index()]; }
  bool is_border(HalfedgeH h) const { return !face(h).valid(); }
  HalfedgeH halfedge(FaceH f) const { return face_halfedge_[f.index()]; }
  // An outgoing half-edge; the border one where the vertex lies on a border.
  HalfedgeH outgoing(VertexH v) const { return vertex_out_[v.index()]; }
  // Next outgoing half-edge about from(h): counter-clockwise, clockwise.
  HalfedgeH rotate_ccw(HalfedgeH h) const { return twin(prev(h)); }
  HalfedgeH rotate_cw(HalfedgeH h) const { return next(twin(h)); }
  // Rings, to loop over: the outgoing half-edges about a vertex or from one of them on, clockwise
  // where not said otherwise; the half-edges of a face, or those that follow one along its face or
  // hole.
  using Star = Ring<SurfaceMesh, &SurfaceMesh::rotate_cw>;
  using StarCcw = Ring<SurfaceMesh, &SurfaceMesh::rotate_ccw>;
  using Loop = Ring<SurfaceMesh, &SurfaceMesh::next>;
  Star around(VertexH v) const { return {*this, outgoing(v)}; }
  Star around(HalfedgeH first) const { return {*this, first}; }
  StarCcw around_ccw(VertexH v) const { return {*this, outgoing(v)}; }
  StarCcw around_ccw(HalfedgeH first) const { return {*this, first}; }
  Loop sides(FaceH f) const { return {*this, halfedge(f)}; }
  Loop sides(HalfedgeH first) const { return {*this, first}; }
  bool is_border(VertexH v) const { return is_border(outgoing(v)); }
  bool is_triangle(HalfedgeH h) const;  // the face left of h
  int degree(FaceH f) const;
  int valence(VertexH v) const;
  HalfedgeH find_halfedge(VertexH from, VertexH to) const;  // invalid where there is none

  // --- data ---
  const VertexData& data(VertexH v) const { return vertex_data_[v.index()]; }
  VertexData& data(VertexH v) { return vertex_data_[v.index()]; }
  const Vec3& position(VertexH v) const { return vertex_data_[v.index()].point.xyz; }
  const FaceData& data(FaceH f) const { return face_data_[f.index()]; }
  FaceData& data(FaceH f) { return face_data_[f.index()]; }
  // A frozen edge is never flipped, split, collapsed or removed.
  bool frozen(HalfedgeH h) const { return frozen_[h.index() >> 1] != 0; }
  void set_frozen(HalfedgeH h, bool frozen) { frozen_[h.index() >> 1] = frozen ? 1 : 0; }
  // The CAD edge a mesh edge lies on; none inside the patch (seams and smooth edges included).
  EdgeId curve(HalfedgeH h) const { return curve_[h.index() >> 1]; }
  void set_curve(HalfedgeH h, EdgeId edge) { curve_[h.index() >> 1] = edge; }

  // --- local operations: a question, which gives the first reason against, then the act ---
  // Acts require that their question said kNone.

  //      c               c
  //    /   \           / | \        split_face(f): f = (a, b, c) becomes three triangles about v
  //   /     \    ->   /  v  \       (c, v), (a, v), (b, v) are new
  //  a ----- b       a ----- b
  VertexH split_face(FaceH f, const VertexData& data);

  //     c                c
  //   /   \            / | \        split_edge(h): h = (a, b) becomes (a, v); (v, b) is new. Both
  //   triangles
  //  a --- b    ->    a--v--b       beside it are halved (one on a border).
  //   \   /            \ | /
  //     d                d
  Veto split_edge_veto(HalfedgeH h) const;
  VertexH split_edge(HalfedgeH h, const VertexData& data);

  //     b               b
  //   / | \           /   \         flip(h): h = (a, b) becomes (d, c), turned counter-clockwise;
  //  c  h  d   ->    c --- d        h keeps its handle
  //   \ | /           \   /
  //     a               a
  Veto flip_veto(HalfedgeH h) const;
  void flip(HalfedgeH h);

  //  a --h--> b: a vanishes, its other edges move to b, the two triangles beside h vanish; quads
  //  elsewhere about a are allowed. A merged edge stays frozen if either was.
  Veto collapse_veto(HalfedgeH h) const;
  void collapse(HalfedgeH h);

  //  combine(h): removes h between two triangles, which become one quad (the face left of h stays).
  Veto combine_veto(HalfedgeH h) const;
  FaceH combine(HalfedgeH h);

  //  divide(f, v): cuts a quad from v to the opposite corner; returns the new half-edge from v.
  HalfedgeH divide(FaceH quad, VertexH v);

  // replace(old, faces): a disc of faces gets other faces within the same loop of edges, frozen
  // edges inside it notwithstanding; vertices inside it that no new face uses vanish. The new faces
  // come in the order given, with data of their own.
  Veto replace_veto(const std::vector<FaceH>& old,
                    const std::vector<std::vector<VertexH>>& faces) const;
  std::vector<FaceH> replace(const std::vector<FaceH>& old,
                             const std::vector<std::vector<VertexH>>& faces);

  void add_observer(MeshObserver* observer);  // not owned
  void remove_observer(MeshObserver* observer);

  // Numbers edges and faces by their vertices, so that meshes that are equal but for the way that
  // they came about are the same. Their tombstones go; handles to them held outside are void.
  // Throws Cancelled, before anything is changed.
  void put_in_order(const RunContext& context);

 private:
  HalfedgeH add_edge(VertexH from, VertexH to);
  FaceH add_face();
  void link(HalfedgeH a, HalfedgeH b);
  template <class Faces>
  void build_of(const RunContext& context, const Faces& faces);
  void link_border();
  void set_triangle(FaceH f, HalfedgeH a, HalfedgeH b, HalfedgeH c);
  std::vector<HalfedgeH> halfedges_by_vertices(const RunContext& context) const;
  HalfedgeH from_least_corner(FaceH f) const;
  void set_outgoing();
  void merge_edges(HalfedgeH kept, HalfedgeH gone);
  void remove_edge(HalfedgeH h);
  void remove_face(FaceH f);
  void remove_vertex(VertexH v);
  void notify_vertex_created(VertexH v);
  void notify_face_created(FaceH f);
  void notify_face_changed(FaceH f);

  std::vector<VertexH> to_;  // by half-edge; invalid: removed
  std::vector<HalfedgeH> next_, prev_;
  std::vector<FaceH> face_;
  std::vector<std::uint8_t> frozen_;  // by edge
  std::vector<EdgeId> curve_;         // by edge
  std::vector<HalfedgeH> vertex_out_;
  std::vector<std::uint8_t> vertex_alive_;
  std::vector<VertexData> vertex_data_;
  std::vector<HalfedgeH> face_halfedge_;  // invalid: removed
  std::vector<FaceData> face_data_;
  std::vector<HalfedgeH> free_edges_;
  std::vector<FaceH> free_faces_;
  std::vector<MeshObserver*> observers_;
  int live_vertices_ = 0, live_edges_ = 0, live_faces_ = 0;
};

}  // namespace advlayers
