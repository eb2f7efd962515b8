#include "core/core_flips.h"

#include <algorithm>

#include "core/core_shape.h"
#include "measure/core_region.h"

namespace advlayers {
namespace {

// A flip must gain, or round-off could turn an edge to and fro for ever.
constexpr double kLeastGain = 1e-6;
constexpr std::size_t kCancelStride = 256;

bool flip_gains(const SurfaceMesh& mesh, HalfedgeH h) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  const VertexH a = mesh.from(h), b = mesh.to(h);
  const VertexH c = mesh.to(mesh.next(h)), d = mesh.to(mesh.next(t));
  const CoreShape left = shape_of(mesh, a, b, c), right = shape_of(mesh, b, a, d);
  const CoreShape low = shape_of(mesh, a, d, c), high = shape_of(mesh, d, b, c);
  if (std::min(low.sine, high.sine) <= std::min(left.sine, right.sine) + kLeastGain) return false;
  return std::min(low.lean, high.lean) >= std::min({kLeastLeanCosine, left.lean, right.lean});
}

}  // namespace

int flip_core(const RunContext& context, SurfaceMesh& mesh) {
  std::vector<HalfedgeH> waiting;
  std::vector<char> listed(mesh.halfedge_capacity() / 2, 0);
  const auto enlist = [&](HalfedgeH h) {
    char& mark = listed[h.index() >> 1];
    if (mark || !is_core_edge(mesh, h)) return;
    mark = 1;
    waiting.push_back(h);
  };
  for (std::size_t i = mesh.halfedge_capacity(); i >= 2; i -= 2) enlist(HalfedgeH(i - 2));
  int flips = 0;
  for (std::size_t step = 0; !waiting.empty(); ++step) {
    if (step % kCancelStride == 0) context.check();
    const HalfedgeH h = waiting.back();
    waiting.pop_back();
    listed[h.index() >> 1] = 0;
    if (mesh.flip_veto(h) != Veto::kNone || !flip_gains(mesh, h)) continue;
    mesh.flip(h);
    ++flips;
    const HalfedgeH t = SurfaceMesh::twin(h);
    for (const HalfedgeH side : {mesh.next(h), mesh.prev(h), mesh.next(t), mesh.prev(t)}) {
      enlist(side);
    }
  }
  return flips;
}

}  // namespace advlayers
