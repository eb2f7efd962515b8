#include "layers/insert_layer.h"

#include <algorithm>

#include "layers/recover.h"

namespace advlayers {
namespace {

constexpr std::size_t kMostFaces = 2000;  // that one cell's region may hold before it is cleared

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool freeze(LayerState& state, VertexH a, VertexH b) {
  const HalfedgeH h = recover_edge(state.mesh, a, b, state.limits, state.report.vetoes);
  if (!h.valid()) return false;
  state.mesh.set_frozen(h, true);
  return true;
}

// The kid becomes an ordinary core vertex again, and goes if it can.
void undo(LayerState& state, Kid& kid) {
  kid.alive = false;
  if (!kid.vertex.valid()) return;
  SurfaceMesh& mesh = state.mesh;
  if (kid.given) {
    if (kid.parents.empty()) return;
    mesh.data(kid.vertex).layer = 0;
    mesh.data(kid.vertex).parent = VertexH();
    return;
  }
  for (const HalfedgeH h : mesh.around(kid.vertex)) {
    mesh.set_frozen(h, false);
  }
  mesh.data(kid.vertex).layer = 0;
  mesh.data(kid.vertex).parent = VertexH();
  remove_core_vertex(mesh, kid.vertex, Removal::kForced, state.limits, state.report.vetoes);
  kid.vertex = VertexH();
}

// The boundary's next node becomes the kid of a chain's end; an end that stands is its own.
void take_given(LayerState& state, const Kid& kid) {
  if (kid.parents.empty()) return;
  VertexData& data = state.mesh.data(kid.vertex);
  data.layer = state.layer;
  data.parent = state.front[kid.origin].vertex;
}

bool insert_vertex(LayerState& state, Kid& kid) {
  VertexData data;
  data.point = kid.point;
  data.normal = kid.normal;
  data.layer = state.layer;
  const VertexH origin = state.front[kid.origin].vertex;
  data.parent = origin;
  kid.vertex = insert_point(state.mesh, origin, data, state.limits, state.report.vetoes);
  kid.alive = kid.vertex.valid();
  return kid.alive;
}

void insert(LayerState& state, Kid& kid) {
  if (kid.given) take_given(state, kid);
  if (!kid.given && !insert_vertex(state, kid)) return;
  for (const int parent : kid.parents) {
    if (!freeze(state, state.front[parent].vertex, kid.vertex)) {
      undo(state, kid);
      return;
    }
  }
}

VertexH vertex_of(const LayerState& state, const LayerPlan& plan, const CellCorner& corner) {
  return corner.node >= 0 ? state.front[corner.node].vertex : plan.kids[index(corner.kid)].vertex;
}

// The edge from corner k of the cell to the next; invalid where it is not in the mesh.
HalfedgeH cell_edge(const LayerState& state, const LayerPlan& plan, const Cell& cell,
                    std::size_t k) {
  const VertexH a = vertex_of(state, plan, cell.corners[k]);
  const VertexH b = vertex_of(state, plan, cell.corners[(k + 1) % cell.corners.size()]);
  return a.valid() && b.valid() ? state.mesh.find_halfedge(a, b) : HalfedgeH();
}

bool recover_sides(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  for (const CellCorner& corner : cell.corners) {
    if (corner.kid >= 0 && !plan.kids[index(corner.kid)].alive) return false;
  }
  for (std::size_t k = 0; k < cell.corners.size(); ++k) {
    const VertexH a = vertex_of(state, plan, cell.corners[k]);
    const VertexH b = vertex_of(state, plan, cell.corners[(k + 1) % cell.corners.size()]);
    if (!freeze(state, a, b)) return false;
  }
  return true;
}

bool is_core(const SurfaceMesh& mesh, HalfedgeH h) {
  return !mesh.is_border(h) && mesh.is_triangle(h) && mesh.data(mesh.face(h)).layer == 0;
}

// Combines the two triangles of a cleared quad.
bool combine(LayerState& state, HalfedgeH side) {
  HalfedgeH h = side;
  for (int k = 0; k < 3 && state.mesh.frozen(h); ++k) h = state.mesh.next(h);
  const Veto veto = state.mesh.combine_veto(h);
  count(state.report.vetoes, veto);
  if (veto != Veto::kNone) return false;
  state.mesh.combine(h);
  ++state.report.quads;
  return true;
}

bool close(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  const HalfedgeH side = cell_edge(state, plan, cell, 0);
  if (!is_core(state.mesh, side)) return false;
  const std::vector<FaceH> faces =
      clear_region(state.mesh, side, kMostFaces, state.limits, state.report.vetoes);
  if (faces.size() != cell.corners.size() - 2) return false;
  if (!cell.layered) return combine(state, side);
  for (const FaceH f : faces) state.mesh.data(f).layer = state.layer;
  return true;
}

// Sides of a failed cell that have core on both sides are no sides of anything.
void release(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  SurfaceMesh& mesh = state.mesh;
  for (std::size_t k = 0; k < cell.corners.size(); ++k) {
    const HalfedgeH h = cell_edge(state, plan, cell, k);
    if (!h.valid() || !is_core(mesh, h) || !is_core(mesh, SurfaceMesh::twin(h))) continue;
    if (mesh.data(mesh.from(h)).layer == state.layer &&
        mesh.data(mesh.to(h)).layer == state.layer) {
      mesh.set_frozen(h, false);
    }
  }
}

}  // namespace

void insert_kids(LayerState& state, LayerPlan& plan) {
  for (Kid& kid : plan.kids) {
    state.context.check();
    if (kid.alive) insert(state, kid);
  }
}

void recover_cells(LayerState& state, LayerPlan& plan) {
  for (Cell& cell : plan.cells) {
    state.context.check();
    if (cell.alive) cell.alive = recover_sides(state, plan, cell);
  }
  std::vector<std::uint8_t> held(plan.kids.size(), 0);
  for (Cell& cell : plan.cells) {
    state.context.check();
    if (cell.alive) cell.alive = close(state, plan, cell);
    if (!cell.alive) continue;
    for (const CellCorner& corner : cell.corners) {
      if (corner.kid >= 0) held[index(corner.kid)] = 1;
    }
  }
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) release(state, plan, cell);
  }
  for (std::size_t k = 0; k < plan.kids.size(); ++k) {
    if (plan.kids[k].alive && held[k] == 0) undo(state, plan.kids[k]);
  }
}

void combine_cells(LayerState& state, const LayerPlan& plan) {
  for (const Cell& cell : plan.cells) {
    if (!cell.alive || !cell.layered) continue;
    if (cell.corners.size() == 3) {
      ++state.report.triangles;
    } else if (!combine(state, cell_edge(state, plan, cell, 0))) {
      state.report.triangles += 2;
    }
  }
}

namespace {

// The next front's nodes, made from kids as they are asked for.
class NodeMaker {
 public:
  explicit NodeMaker(const LayerPlan& plan) : plan_(plan), node_of_(plan.kids.size(), -1) {}
  int at(int k) {
    int& i = node_of_[index(k)];
    if (i >= 0) return i;
    i = static_cast<int>(nodes_.size());
    const Kid& kid = plan_.kids[index(k)];
    FrontNode node;
    node.vertex = kid.vertex;
    node.growth = kid.growth;
    node.root = kid.root;
    node.fan_age = kid.fan_age;
    node.lag = kid.lag;
    nodes_.push_back(node);
    return i;
  }
  void join(int p, int q) {
    const int a = at(p), b = at(q);
    nodes_[index(a)].next = b;
    nodes_[index(b)].prev = a;
  }
  std::vector<FrontNode> release() { return std::move(nodes_); }

 private:
  const LayerPlan& plan_;
  std::vector<int> node_of_;
  std::vector<FrontNode> nodes_;
};

// Sides that face the core and are no front stay where they are.
void leave_idle_sides(LayerState& state, const LayerPlan& plan) {
  const SurfaceMesh& mesh = state.mesh;
  for (const Cell& cell : plan.cells) {
    for (std::size_t k = 0; k < cell.corners.size(); ++k) {
      const CellCorner& a = cell.corners[k];
      const CellCorner& b = cell.corners[(k + 1) % cell.corners.size()];
      const bool front = std::any_of(cell.fronts.begin(), cell.fronts.end(),
                                     [&](const auto& f) { return a.kid == f[1] && b.kid == f[0]; });
      if (front && cell.alive) continue;
      const HalfedgeH h = cell_edge(state, plan, cell, k);
      if (!h.valid() || !mesh.frozen(h)) continue;
      // Seen from an alive cell the core lies beyond the side; a failed cell is core itself.
      const HalfedgeH inner = cell.alive ? SurfaceMesh::twin(h) : h;
      if (is_core(mesh, inner)) state.front.add_idle_edge(inner);
    }
  }
}

}  // namespace

void advance_front(LayerState& state, const LayerPlan& plan) {
  Front& front = state.front;
  NodeMaker maker(plan);
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) continue;
    for (const auto& [p, q] : cell.fronts) maker.join(p, q);
  }
  leave_idle_sides(state, plan);
  for (int i = 0; i < front.size(); ++i) {
    if (!front[i].active) continue;
    const auto& kids = plan.kids_of[index(i)];
    const bool grew =
        std::any_of(kids.begin(), kids.end(), [&](int k) { return plan.kids[index(k)].alive; });
    if (!grew) state.note_stop(i, Stop::kBlocked);
  }
  front.replace(maker.release());
}

}  // namespace advlayers
