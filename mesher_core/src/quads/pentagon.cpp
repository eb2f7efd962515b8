#include "quads/pentagon.h"

namespace advlayers {

Pentagon pentagon_at(const SurfaceMesh& mesh, HalfedgeH shared, VertexH p) {
  const HalfedgeH inside = SurfaceMesh::twin(shared);  // from b to a, in the quad
  const HalfedgeH ad = mesh.next(inside), dc = mesh.next(ad);
  return {p, mesh.to(inside), mesh.to(ad), mesh.to(dc), mesh.from(inside)};
}

PentagonHalves halves_of(const Pentagon& v, PentagonCut cut) {
  switch (cut) {
    case PentagonCut::kA:
      return {{v.p, v.a, v.d}, {v.p, v.d, v.c, v.b}};
    case PentagonCut::kB:
      return {{v.c, v.b, v.p}, {v.p, v.a, v.d, v.c}};
    case PentagonCut::kC:
      return {{v.d, v.c, v.b}, {v.p, v.a, v.d, v.b}};
    case PentagonCut::kD:
      return {{v.a, v.d, v.c}, {v.p, v.a, v.c, v.b}};
    case PentagonCut::kP:
      break;
  }
  return {{v.p, v.a, v.b}, {v.a, v.d, v.c, v.b}};
}

bool recut(SurfaceMesh& mesh, HalfedgeH shared, PentagonCut cut) {
  if (cut == PentagonCut::kP) return true;
  const HalfedgeH inside = SurfaceMesh::twin(shared);
  const VertexH a = mesh.to(inside), b = mesh.from(inside);
  const bool from_a = cut == PentagonCut::kB || cut == PentagonCut::kD;
  // Right of the new half-edge lies what keeps the quad's handle: callers rely on that, too.
  const HalfedgeH diagonal = SurfaceMesh::twin(mesh.divide(mesh.face(inside), from_a ? a : b));
  HalfedgeH seam = shared;
  if (cut == PentagonCut::kA || cut == PentagonCut::kB) {
    if (mesh.flip_veto(shared) != Veto::kNone) {
      mesh.combine(diagonal);
      return false;
    }
    mesh.flip(shared);
    seam = diagonal;
  }
  if (mesh.combine_veto(seam) == Veto::kNone) {
    mesh.combine(seam);
    return true;
  }
  if (seam == diagonal) {
    // Only four flips in all give the half-edge its first direction back, which callers rely on.
    for (int k = 0; k < 3; ++k) mesh.flip(shared);
  }
  mesh.combine(diagonal);
  return false;
}

}  // namespace advlayers
