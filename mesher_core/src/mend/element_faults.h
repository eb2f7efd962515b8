// What is wrong with an element: how far it leans from the surface, folds or reaches around a bend.
#pragma once

#include <array>

#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// The corners of a triangle or quad, of the mesh or only thought of.
struct FaceCorners {
  FaceCorners() = default;
  FaceCorners(const std::array<VertexH, 3>& v) : vertex{v[0], v[1], v[2]}, count(3) {}
  FaceCorners(const std::array<VertexH, 4>& v) : vertex(v), count(4) {}

  std::array<VertexH, 4> vertex;
  std::size_t count = 0;

  std::size_t size() const { return count; }
  VertexH operator[](std::size_t k) const { return vertex[k]; }
  const VertexH* begin() const { return vertex.data(); }
  const VertexH* end() const { return vertex.data() + count; }
};
FaceCorners corners_around(const SurfaceMesh& mesh, FaceH face);

// Two elements that lean less than 60 degrees from a surface that does not turn make no fold of
// 120.
inline constexpr double kSteep = 0.5;

// The cosine between the element's normal and the surface's at the foot of its centroid, or 1 where
// the corners' normals tell that it is upright; -1 where it has no area.
double uprightness(const SurfaceMesh& mesh, const FaceCorners& corners, PatchSurface& surface);

// From this weight of faults on an element is turned over, or a corner of it is: it is invalid.
inline constexpr int kInvalid = 2;

// What mending is to remove, by weight: an element turned over weighs most, then a folded corner of
// a quad, then a steep element, or one that reaches around a bend. 0: none of these.
int faults_of(const SurfaceMesh& mesh, const FaceCorners& corners, PatchSurface& surface);

}  // namespace advlayers
