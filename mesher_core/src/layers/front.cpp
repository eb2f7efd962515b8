#include "layers/front.h"

#include <algorithm>
#include <cmath>

#include "base/directions.h"

namespace advlayers {
namespace {

// The inner half-edge after `inner` along the patch's boundary, the core on its left.
HalfedgeH next_along_border(const SurfaceMesh& mesh, HalfedgeH inner) {
  return SurfaceMesh::twin(mesh.prev(SurfaceMesh::twin(inner)));
}

const EdgePlan* wall_of(const SurfaceMesh& mesh, HalfedgeH inner, const WallPlan& plan) {
  const auto found = plan.edges.find(mesh.curve(inner));
  if (found == plan.edges.end() || found->second.condition != EdgeCondition::kWall) return nullptr;
  return &found->second;
}

}  // namespace

Front::Front(const SurfaceMesh& mesh, const WallPlan& plan) {
  std::vector<int> node_of(mesh.vertex_capacity(), -1);
  const auto node_at = [&](VertexH v, const EdgePlan& wall) {
    int& i = node_of[v.index()];
    if (i < 0) {
      i = size();
      FrontNode node;
      node.vertex = node.root = v;
      node.growth = wall.growth_at(mesh.data(v).node);
      nodes_.push_back(node);
    } else {  // between two walls: the mean height, the fewer layers
      FrontNode& node = nodes_[static_cast<std::size_t>(i)];
      node.growth = node.growth.met_by(wall.growth_at(mesh.data(v).node));
    }
    return i;
  };
  std::vector<std::uint8_t> seen(mesh.halfedge_capacity(), 0);
  for (std::size_t k = 0; k < mesh.halfedge_capacity(); ++k) {
    const HalfedgeH first(k);
    if (!mesh.alive(first) || mesh.is_border(first) || seen[k] != 0) continue;
    if (!mesh.is_border(SurfaceMesh::twin(first))) continue;
    HalfedgeH h = first;
    do {
      seen[h.index()] = 1;
      if (const EdgePlan* wall = wall_of(mesh, h, plan)) {
        const int a = node_at(mesh.from(h), *wall), b = node_at(mesh.to(h), *wall);
        nodes_[static_cast<std::size_t>(a)].next = b;
        nodes_[static_cast<std::size_t>(b)].prev = a;
      } else {
        idle_edges_.push_back(h);
      }
      h = next_along_border(mesh, h);
    } while (h != first);
  }
}

int Front::active_count() const {
  return static_cast<int>(
      std::count_if(nodes_.begin(), nodes_.end(), [](const FrontNode& n) { return n.active; }));
}

void Front::bridge(int before, int after) {
  for (int i = (*this)[before].next; i >= 0 && i != after;) {
    FrontNode& node = (*this)[i];
    i = node.next;
    node.active = false;
    node.prev = node.next = -1;
  }
  (*this)[before].next = after;
  (*this)[after].prev = before;
}

void Front::split_at_rung(int p, int q) {
  const int new_p = size(), new_q = size() + 1;
  nodes_.push_back((*this)[p]);
  nodes_.push_back((*this)[q]);
  for (const auto& [node, other] : {std::pair{p, new_q}, std::pair{q, new_p}}) {
    (*this)[node].next = other;
    (*this)[other].prev = node;
  }
  for (const int node : {new_p, new_q}) (*this)[(*this)[node].next].prev = node;
}

void Front::split_at_triangle(int p, int q) {
  const int new_p = size(), after_p = (*this)[p].next, after_q = (*this)[q].next;
  nodes_.push_back((*this)[p]);
  for (const auto& [a, b] :
       {std::pair{p, after_q}, std::pair{q, new_p}, std::pair{new_p, after_p}}) {
    (*this)[a].next = b;
    (*this)[b].prev = a;
  }
}

int Front::ring_size(int i, int most) const {
  int n = 0;
  int k = i;
  do {
    if (++n > most) return -1;
    k = (*this)[k].next;
  } while (k >= 0 && k != i);
  return k < 0 ? -1 : n;
}

Vec3 rotated(const Vec3& direction, const Vec3& normal, double angle) {
  return std::cos(angle) * direction + std::sin(angle) * normal.cross(direction);
}

namespace {

// The boundary returns along the way that it came: round-off alone would say whether the patch
// takes up nothing there or all about it.
bool at_slit_end(const SurfaceMesh& mesh, const Front& front, int i) {
  const FrontNode& node = front[i];
  if (node.prev < 0 || node.next < 0) return false;
  const NodeId before = mesh.data(front[node.prev].vertex).node;
  return before.valid() && before == mesh.data(front[node.next].vertex).node;
}

}  // namespace

NodeShape node_shape(const SurfaceMesh& mesh, const Front& front, int i) {
  const FrontNode& node = front[i];
  NodeShape shape;
  shape.normal = mesh.data(node.vertex).normal;
  const Vec3& p = mesh.position(node.vertex);
  const auto towards = [&](int k, double& length) -> Vec3 {
    const Vec3 chord = mesh.position(front[k].vertex) - p;
    length = chord.norm();
    return (chord - chord.dot(shape.normal) * shape.normal).normalized();
  };
  if (node.next >= 0) shape.to_next = towards(node.next, shape.length_next);
  if (node.prev >= 0) shape.to_prev = towards(node.prev, shape.length_prev);
  if (node.next < 0) {
    shape.to_next = -shape.to_prev;
    shape.length_next = shape.length_prev;
  }
  if (node.prev < 0) {
    shape.to_prev = -shape.to_next;
    shape.length_prev = shape.length_next;
  }
  shape.angle = at_slit_end(mesh, front, i)
                    ? 2.0 * M_PI
                    : turn_angle(shape.to_next, shape.to_prev, shape.normal);
  shape.inward = rotated(shape.to_next, shape.normal, 0.5 * shape.angle);
  return shape;
}

}  // namespace advlayers
