#include "layers/insert_layer.h"

#include <algorithm>

#include "layers/recover.h"

namespace advlayers {
namespace {

constexpr std::size_t kMostFaces = 2000;  // that one cell's region may hold before it is cleared

std::size_t index(int i) { return static_cast<std::size_t>(i); }

bool freeze(LayerState& state, VertexH a, VertexH b) {
  const HalfedgeH h = recover_edge(state.mesh, a, b, state.limits, state.report->vetoes);
  if (!h.valid()) return false;
  state.mesh.set_frozen(h, true);
  return true;
}

// The kid becomes an ordinary core vertex again, and goes if it can.
void undo(LayerState& state, Kid& kid) {
  kid.alive = false;
  if (!kid.vertex.valid()) return;
  SurfaceMesh& mesh = state.mesh;
  const HalfedgeH first = mesh.outgoing(kid.vertex);
  HalfedgeH h = first;
  do {
    mesh.set_frozen(h, false);
    h = mesh.rotate_cw(h);
  } while (h != first);
  mesh.data(kid.vertex).layer = 0;
  mesh.data(kid.vertex).parent = VertexH();
  remove_core_vertex(mesh, kid.vertex, Removal::kForced, state.limits, state.report->vetoes);
  kid.vertex = VertexH();
}

void insert(LayerState& state, Kid& kid) {
  VertexData data;
  data.point = kid.point;
  data.normal = kid.normal;
  data.layer = state.layer;
  const VertexH origin = state.front[kid.origin].vertex;
  data.parent = origin;
  kid.vertex = insert_point(state.mesh, origin, data, state.limits, state.report->vetoes);
  if (!kid.vertex.valid()) {
    kid.alive = false;
    return;
  }
  for (const int parent : kid.parents) {
    if (!freeze(state, state.front[parent].vertex, kid.vertex)) {
      undo(state, kid);
      return;
    }
  }
}

// The edges between the kids of a cell; a fan's diagonal kid stands between two.
bool recover_kid_edges(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  std::vector<int> chain{cell.kid_from};
  if (cell.diagonal >= 0) chain.push_back(cell.diagonal);
  if (cell.kid_to != cell.kid_from) chain.push_back(cell.kid_to);
  for (const int kid : chain) {
    if (!plan.kids[index(kid)].alive) return false;
  }
  for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
    if (!freeze(state, plan.kids[index(chain[k])].vertex, plan.kids[index(chain[k + 1])].vertex)) {
      return false;
    }
  }
  return true;
}

// A half-edge of the cell with the cell on its left, and how many triangles fill it.
HalfedgeH cell_edge(const LayerState& state, const LayerPlan& plan, const Cell& cell) {
  const SurfaceMesh& mesh = state.mesh;
  const VertexH from = state.front[cell.from].vertex;
  if (cell.diagonal >= 0) return mesh.find_halfedge(from, plan.kids[index(cell.kid_to)].vertex);
  const int along = cell.middle >= 0 ? cell.middle : cell.to;
  return mesh.find_halfedge(from, state.front[along].vertex);
}
std::size_t cell_triangles(const Cell& cell) {
  return cell.diagonal < 0 && cell.middle < 0 && cell.kid_from == cell.kid_to ? 1 : 2;
}

bool close(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  const std::vector<FaceH> faces = clear_region(state.mesh, cell_edge(state, plan, cell),
                                                kMostFaces, state.limits, state.report->vetoes);
  if (faces.size() != cell_triangles(cell)) return false;
  for (const FaceH f : faces) state.mesh.data(f).layer = state.layer;
  return true;
}

// A failed cell's kid edge is no front.
void release(LayerState& state, const LayerPlan& plan, const Cell& cell) {
  const Kid& p = plan.kids[index(cell.kid_from)];
  const Kid& q = plan.kids[index(cell.kid_to)];
  if (p.vertex.valid() && q.vertex.valid() && p.vertex != q.vertex) {
    const HalfedgeH h = state.mesh.find_halfedge(p.vertex, q.vertex);
    if (h.valid()) state.mesh.set_frozen(h, false);
  }
}

}  // namespace

void insert_kids(LayerState& state, LayerPlan& plan) {
  for (Kid& kid : plan.kids) {
    state.cancel->check();
    if (kid.alive) insert(state, kid);
  }
}

void recover_cells(LayerState& state, LayerPlan& plan) {
  for (Cell& cell : plan.cells) {
    state.cancel->check();
    if (cell.alive) cell.alive = recover_kid_edges(state, plan, cell);
    if (!cell.alive) release(state, plan, cell);
  }
  for (Cell& cell : plan.cells) {
    state.cancel->check();
    if (!cell.alive) continue;
    cell.alive = close(state, plan, cell);
    if (!cell.alive) release(state, plan, cell);
  }
  std::vector<std::uint8_t> held(plan.kids.size(), 0);
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) continue;
    for (const int kid : {cell.kid_from, cell.kid_to, cell.diagonal}) {
      if (kid >= 0) held[index(kid)] = 1;
    }
  }
  for (std::size_t k = 0; k < plan.kids.size(); ++k) {
    if (plan.kids[k].alive && held[k] == 0) undo(state, plan.kids[k]);
  }
}

void combine_cells(LayerState& state, const LayerPlan& plan) {
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) continue;
    if (cell_triangles(cell) == 1) {
      ++state.report->triangles;
      continue;
    }
    HalfedgeH h = cell_edge(state, plan, cell);
    for (int k = 0; k < 3 && state.mesh.frozen(h); ++k) h = state.mesh.next(h);
    const Veto veto = state.mesh.combine_veto(h);
    count(state.report->vetoes, veto);
    if (veto == Veto::kNone) {
      state.mesh.combine(h);
      ++state.report->quads;
    } else {
      state.report->triangles += 2;
    }
  }
}

void advance_front(LayerState& state, const LayerPlan& plan) {
  Front& front = state.front;
  std::vector<int> node_of(plan.kids.size(), -1);
  std::vector<FrontNode> nodes;
  const auto node_at = [&](int k) {
    int& i = node_of[index(k)];
    if (i >= 0) return i;
    i = static_cast<int>(nodes.size());
    const Kid& kid = plan.kids[index(k)];
    FrontNode node;
    node.vertex = kid.vertex;
    node.height = kid.height;
    node.growth = kid.growth;
    node.layers_left = kid.layers_left;
    node.root = kid.root;
    node.fan_age = kid.fan_age;
    nodes.push_back(node);
    return i;
  };
  const auto join = [&](int p, int q) {
    const int a = node_at(p), b = node_at(q);
    nodes[index(a)].next = b;
    nodes[index(b)].prev = a;
  };
  std::vector<std::uint8_t> covered(front.nodes().size(), 0);
  for (const Cell& cell : plan.cells) {
    if (!cell.alive) continue;
    covered[index(cell.from)] = 1;
    if (cell.middle >= 0) covered[index(cell.middle)] = 1;
    if (cell.diagonal >= 0) {
      join(cell.kid_from, cell.diagonal);
      join(cell.diagonal, cell.kid_to);
    } else if (cell.kid_from != cell.kid_to) {
      join(cell.kid_from, cell.kid_to);
    } else {
      node_at(cell.kid_from);
    }
  }
  // A front edge that no cell covers stays between its parents.
  for (int i = 0; i < front.size(); ++i) {
    const FrontNode& node = front[i];
    if (!node.active) continue;
    if (node.next >= 0 && covered[index(i)] == 0) {
      const HalfedgeH h = state.mesh.find_halfedge(node.vertex, front[node.next].vertex);
      if (h.valid()) front.add_idle_edge(h);
    }
    const auto& kids = plan.kids_of[index(i)];
    const bool grew =
        std::any_of(kids.begin(), kids.end(), [&](int k) { return plan.kids[index(k)].alive; });
    if (!grew) state.note_stop(i, Stop::kBlocked);
  }
  front.replace(std::move(nodes));
}

}  // namespace advlayers
