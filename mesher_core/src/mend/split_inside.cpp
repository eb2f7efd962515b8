#include "mend/split_inside.h"

#include <limits>

namespace advlayers {
namespace {

// Divides the quad left of `side` from its begin; returns the diagonal, or an invalid handle where
// a triangle lies there.
HalfedgeH divide_beside(SurfaceMesh& mesh, HalfedgeH side) {
  if (mesh.is_triangle(side)) return {};
  return mesh.divide(mesh.face(side), mesh.from(side));
}

// The nearest of the feet of the edge's middle, sought from its ends and from the corners beside
// it: a long edge may lie far off the surface, where one search alone is led astray.
bool find_middle(const SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h,
                 SurfacePoint& nearest) {
  const HalfedgeH t = SurfaceMesh::twin(h);
  const Vec3 middle = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
  double least = std::numeric_limits<double>::infinity();
  for (const VertexH seed :
       {mesh.from(h), mesh.to(h), mesh.to(mesh.next(h)), mesh.to(mesh.next(t))}) {
    SurfacePoint foot;
    if (!surface.project(middle, mesh.data(seed).point, foot)) continue;
    const double distance = (foot.xyz - middle).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = foot;
  }
  return least < std::numeric_limits<double>::infinity();
}

}  // namespace

VertexH split_inside(SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h) {
  VertexData middle;
  if (!find_middle(mesh, surface, h, middle.point)) return {};
  middle.normal = surface.normal(middle.point);
  const HalfedgeH diagonals[2] = {divide_beside(mesh, h),
                                  divide_beside(mesh, SurfaceMesh::twin(h))};
  mesh.set_frozen(h, false);
  const VertexH v = mesh.split_edge(h, middle);
  for (const HalfedgeH diagonal : diagonals) {
    if (diagonal.valid()) mesh.flip(diagonal);  // towards v, which no edge has led to yet
  }
  return v;
}

}  // namespace advlayers
