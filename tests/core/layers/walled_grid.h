// A grid of triangles in the plane whose border is a CAD boundary: the smallest mesh with a front.
#pragma once

#include "layers/wall_plan.h"
#include "mesh_fixtures.h"

namespace advlayers::test {

inline SurfaceMesh walled_grid(int nx, int ny) {
  SurfaceMesh mesh = triangle_grid(nx, ny);
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!mesh.is_border(h)) continue;
    const Vec3 middle = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
    const int side = middle.y() <= 0.0 ? 0 : middle.x() >= nx ? 1 : middle.y() >= ny ? 2 : 3;
    mesh.set_curve(h, EdgeId(side));
    mesh.set_frozen(h, true);
    mesh.data(mesh.from(h)).support = Support::kEdge;
  }
  return mesh;
}

inline VertexH at(int nx, int i, int j) { return VertexH(j * (nx + 1) + i); }

inline WallPlan walls_on(std::initializer_list<int> sides, double first_height = 0.1) {
  WallPlan plan;
  for (const int side : sides) {
    EdgePlan& edge = plan.edges[EdgeId(side)];
    edge.condition = EdgeCondition::kWall;
    edge.growth.height = first_height;
    edge.growth.ratio = 1.2;
  }
  return plan;
}

// Freezes the straight run of grid edges from one vertex to another.
inline void freeze_run(SurfaceMesh& mesh, int nx, int i0, int j0, int i1, int j1) {
  const int di = (i1 > i0) - (i1 < i0), dj = (j1 > j0) - (j1 < j0);
  for (int i = i0, j = j0; i != i1 || j != j1; i += di, j += dj) {
    mesh.set_frozen(mesh.find_halfedge(at(nx, i, j), at(nx, i + di, j + dj)), true);
  }
}

}  // namespace advlayers::test
