// Angles and normals of flat-sided triangles and quads in space, counted as the report and the bars
// count them: the angle at a corner lies between its two edges, and is reflex where the corner
// turns against the element's own normal.
#pragma once

#include <array>

#include "mesh/surface_mesh.h"

namespace advlayers {

// The corners of one element, counter-clockwise; three or four are used.
struct ElementCorners {
  std::array<Vec3, 4> at;
  int count = 0;

  const Vec3& next(int k) const { return at[static_cast<std::size_t>(k + 1 < count ? k + 1 : 0)]; }
  const Vec3& prev(int k) const { return at[static_cast<std::size_t>(k > 0 ? k - 1 : count - 1)]; }
};

ElementCorners corners_of(const SurfaceMesh& mesh, FaceH face);

// The area vector: its length is the (projected) area [mm^2], its direction the normal.
Vec3 area_vector(const ElementCorners& element);
Vec3 centroid(const ElementCorners& element);

// Interior angles [deg] in [0, 360), one per corner.
std::array<double, 4> interior_angles(const ElementCorners& element);

// How near a quad comes to right angles: 1 - max |cos| over its corners, 1 for a rectangle; the
// order is that of the paper's 1 / (largest deviation from 90 degrees) (II.H), without its pole.
// To single precision (see ties.h). Negative where a corner turns against `normal` (the quad is
// folded or concave there).
double right_angle_quality(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d,
                           const Vec3& normal);

// The right-angle quality of the quad that four vertices make, against its own normal; negative
// also where it leans so far from the surface at a corner that it may not lie on it at all, or
// where a corner is none against the surface's normal there.
double quad_quality(const SurfaceMesh& mesh, VertexH a, VertexH b, VertexH c, VertexH d);

// The sine of the smallest angle of a triangle, to single precision (see ties.h); negative where it
// turns against `normal`.
double min_angle_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal);

}  // namespace advlayers
