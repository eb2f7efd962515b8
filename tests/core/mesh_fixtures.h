// Small hand-made meshes, and the check that every operation must pass.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "mesh/surface_mesh.h"
#include "mesh/validate.h"

#define EXPECT_VALID(mesh) EXPECT_EQ(::advlayers::find_connectivity_fault(mesh), "")
#define EXPECT_UPRIGHT(mesh) EXPECT_EQ(::advlayers::find_inverted_element(mesh), "")

namespace advlayers {

inline VertexData flat_vertex(double x, double y) {
  VertexData data;
  data.point.face = FaceId(0);
  data.point.u = x;
  data.point.v = y;
  data.point.xyz = Vec3(x, y, 0.0);
  data.normal = Vec3::UnitZ();
  return data;
}

// nx x ny unit squares in the plane z = 0, each cut from lower left to upper right.
inline SurfaceMesh triangle_grid(int nx, int ny) {
  SurfaceMesh mesh;
  for (int j = 0; j <= ny; ++j) {
    for (int i = 0; i <= nx; ++i) mesh.add_vertex(flat_vertex(i, j));
  }
  std::vector<std::vector<VertexH>> faces;
  const auto at = [&](int i, int j) { return VertexH(j * (nx + 1) + i); };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  mesh.build(faces);
  return mesh;
}

inline VertexData centroid_of(const SurfaceMesh& mesh, FaceH f) {
  Vec3 sum = Vec3::Zero();
  for (const HalfedgeH h : mesh.sides(f)) sum += mesh.position(mesh.to(h));
  sum /= mesh.degree(f);
  return flat_vertex(sum.x(), sum.y());
}

inline VertexData midpoint_of(const SurfaceMesh& mesh, HalfedgeH h) {
  const Vec3 mid = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
  return flat_vertex(mid.x(), mid.y());
}

// The first edge with a triangle on both sides and no end on the border's corner.
inline HalfedgeH inner_diagonal(const SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (mesh.alive(h) && mesh.flip_veto(h) == Veto::kNone && mesh.combine_veto(h) == Veto::kNone) {
      return h;
    }
  }
  return {};
}

// Applies legal operations at random places; topology only, so elements may overlap.
inline void random_operations(SurfaceMesh& mesh, int count, unsigned seed) {
  std::mt19937 random(seed);
  for (int k = 0; k < count; ++k) {
    const HalfedgeH h(static_cast<std::int32_t>(random() % mesh.halfedge_capacity()));
    if (!mesh.alive(h)) continue;
    switch (random() % 6) {
      case 0:
        if (!mesh.is_border(h) && mesh.is_triangle(h)) {
          mesh.split_face(mesh.face(h), centroid_of(mesh, mesh.face(h)));
        }
        break;
      case 1:
        if (mesh.split_edge_veto(h) == Veto::kNone) mesh.split_edge(h, midpoint_of(mesh, h));
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
      default:
        if (!mesh.is_border(h) && !mesh.is_triangle(h) &&
            !mesh.find_halfedge(mesh.from(h), mesh.to(mesh.next(h))).valid()) {
          mesh.divide(mesh.face(h), mesh.from(h));
        }
    }
  }
}

}  // namespace advlayers
