// libFuzzer on sequences of local operations of the half-edge mesh: each byte pair chooses an
// operation and its place; after every one that its question allows the mesh must be sound.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "mesh/surface_mesh.h"
#include "mesh/validate.h"

namespace {

using namespace advlayers;

constexpr int kCells = 4;              // of the grid in one direction
constexpr std::size_t kLongest = 200;  // operations

VertexData vertex_at(const Vec3& xyz) {
  VertexData data;
  data.point.face = FaceId(0);
  data.point.xyz = xyz;
  data.normal = Vec3::UnitZ();
  return data;
}

SurfaceMesh grid() {
  SurfaceMesh mesh;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) mesh.add_vertex(vertex_at(Vec3(i, j, 0.0)));
  }
  std::vector<std::vector<VertexH>> faces;
  const auto at = [](int i, int j) { return VertexH(j * (kCells + 1) + i); };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      if ((i + j) % 3 == 0) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        continue;
      }
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.build(faces);
  return mesh;
}

VertexData middle_of(const SurfaceMesh& mesh, HalfedgeH h) {
  return vertex_at(0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h))));
}

void divide(SurfaceMesh& mesh, HalfedgeH h) {
  if (mesh.is_border(h) || mesh.is_triangle(h)) return;
  if (mesh.find_halfedge(mesh.from(h), mesh.to(mesh.next(h))).valid()) return;
  mesh.divide(mesh.face(h), mesh.from(h));
}

// Two neighbours become the triangles of their loop, turned the other way about where they are a
// quad's.
void replace(SurfaceMesh& mesh, HalfedgeH h) {
  const HalfedgeH twin = SurfaceMesh::twin(h);
  if (mesh.is_border(h) || mesh.is_border(twin)) return;
  if (!mesh.is_triangle(h) || !mesh.is_triangle(twin)) return;
  const VertexH a = mesh.from(h), b = mesh.to(h);
  const VertexH c = mesh.to(mesh.next(h)), d = mesh.to(mesh.next(twin));
  const std::vector<FaceH> old{mesh.face(h), mesh.face(twin)};
  const std::vector<std::vector<VertexH>> faces{{a, d, c}, {d, b, c}};
  if (mesh.replace_veto(old, faces) == Veto::kNone) mesh.replace(old, faces);
}

void operate(SurfaceMesh& mesh, unsigned operation, HalfedgeH h) {
  switch (operation % 9) {
    case 0:
      if (!mesh.is_border(h) && mesh.is_triangle(h)) {
        mesh.split_face(mesh.face(h), middle_of(mesh, h));
      }
      break;
    case 1:
      if (mesh.split_edge_veto(h) == Veto::kNone) mesh.split_edge(h, middle_of(mesh, h));
      break;
    case 2:
      if (mesh.flip_veto(h) == Veto::kNone) mesh.flip(h);
      break;
    case 3:
      if (mesh.collapse_veto(h) == Veto::kNone) mesh.collapse(h);
      break;
    case 4:
      if (mesh.combine_veto(h) == Veto::kNone) mesh.combine(h);
      break;
    case 5:
      divide(mesh, h);
      break;
    case 6:
      replace(mesh, h);
      break;
    case 7:
      mesh.set_frozen(h, !mesh.frozen(h));
      break;
    default:
      mesh.put_in_order();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SurfaceMesh mesh = grid();
  const int euler = euler_number(mesh);
  for (std::size_t i = 0; i + 1 < size && i < 2 * kLongest; i += 2) {
    const HalfedgeH h(static_cast<std::size_t>(data[i + 1]) % mesh.halfedge_capacity());
    if (!mesh.alive(h)) continue;
    operate(mesh, data[i], h);
    const std::string fault = find_connectivity_fault(mesh);
    if (fault.empty() && euler_number(mesh) == euler) continue;
    std::fprintf(stderr, "operation %zu: %s\n", i / 2, fault.c_str());
    std::abort();
  }
  return 0;
}
