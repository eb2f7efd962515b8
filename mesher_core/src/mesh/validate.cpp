#include "mesh/validate.h"

namespace advlayers {
namespace {

std::string at(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index);
}

std::string halfedge_fault(const SurfaceMesh& mesh, HalfedgeH h) {
  const HalfedgeH n = mesh.next(h);
  if (!n.valid() || !mesh.alive(n)) return at("dead next of half-edge", h.index());
  if (mesh.prev(n) != h) return at("prev(next) differs at half-edge", h.index());
  if (mesh.from(n) != mesh.to(h))
    return at("next does not start at the end of half-edge", h.index());
  if (mesh.face(n) != mesh.face(h)) return at("next lies in another face at half-edge", h.index());
  if (!mesh.alive(mesh.to(h))) return at("dead end vertex of half-edge", h.index());
  if (mesh.is_border(h) && mesh.is_border(SurfaceMesh::twin(h))) {
    return at("no face on either side of half-edge", h.index());
  }
  return {};
}

std::string vertex_fault(const SurfaceMesh& mesh, VertexH v, const std::vector<int>& out_degree) {
  const HalfedgeH first = mesh.outgoing(v);
  if (!first.valid() || !mesh.alive(first)) return at("no outgoing half-edge at vertex", v.index());
  if (mesh.from(first) != v)
    return at("outgoing half-edge starts elsewhere than vertex", v.index());
  int n = 0;
  bool border = false;
  for (const HalfedgeH h : mesh.around(v)) {
    border = border || mesh.is_border(h);
    if (++n > out_degree[v.index()]) break;
  }
  if (n != out_degree[v.index()]) return at("the star is no disc at vertex", v.index());
  if (border && !mesh.is_border(first))
    return at("outgoing is not the border one at vertex", v.index());
  return {};
}

}  // namespace

std::string find_connectivity_fault(const SurfaceMesh& mesh) {
  return find_connectivity_fault(RunContext(), mesh);
}

std::string find_connectivity_fault(const RunContext& context, const SurfaceMesh& mesh) {
  std::vector<int> out_degree(mesh.vertex_capacity(), 0);
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    context.check();
    const HalfedgeH h(i);
    if (!mesh.alive(h)) continue;
    if (std::string fault = halfedge_fault(mesh, h); !fault.empty()) return fault;
    ++out_degree[mesh.from(h).index()];
  }
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    if (!mesh.alive(mesh.halfedge(f))) return at("dead half-edge of face", i);
    if (mesh.face(mesh.halfedge(f)) != f) return at("half-edge of another face at face", i);
    const int n = mesh.degree(f);
    if (n != 3 && n != 4) return at("neither triangle nor quad: face", i);
  }
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    context.check();
    const VertexH v(i);
    if (!mesh.alive(v)) continue;
    if (std::string fault = vertex_fault(mesh, v, out_degree); !fault.empty()) return fault;
  }
  return {};
}

std::string find_inverted_element(const SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    Vec3 normal = Vec3::Zero();
    for (const HalfedgeH h : mesh.sides(f)) normal += mesh.data(mesh.from(h)).normal;
    for (const HalfedgeH h : mesh.sides(f)) {
      const Vec3& p = mesh.position(mesh.to(h));
      const Vec3 a = mesh.position(mesh.from(h)) - p;
      const Vec3 b = mesh.position(mesh.to(mesh.next(h))) - p;
      if (b.cross(a).dot(normal) <= 0.0) return at("inverted element", i);
    }
  }
  return {};
}

int euler_number(const SurfaceMesh& mesh) {
  return mesh.vertex_count() - mesh.edge_count() + mesh.face_count();
}

}  // namespace advlayers
