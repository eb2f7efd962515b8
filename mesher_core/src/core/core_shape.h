// How good a triangle of the core is, and how well it lies on the surface.
#pragma once

#include "measure/element_measures.h"

namespace advlayers {

struct CoreShape {
  double sine = 0.0;  // of the smallest angle; negative: turned over
  double lean = 0.0;  // cosine of the angle to the surface
};

inline constexpr double kLeastLeanCosine = 0.8660254037844386;  // of 30 degrees

inline CoreShape shape_of(const SurfaceMesh& mesh, VertexH a, VertexH b, VertexH c) {
  const Vec3 surface = mesh.data(a).normal + mesh.data(b).normal + mesh.data(c).normal;
  const Vec3& pa = mesh.position(a);
  const Vec3 turn = (mesh.position(b) - pa).cross(mesh.position(c) - pa);
  const double norms = turn.norm() * surface.norm();
  return {min_angle_sine(pa, mesh.position(b), mesh.position(c), surface),
          norms > 0.0 ? turn.dot(surface) / norms : -1.0};
}

}  // namespace advlayers
