// Orientation, angles and deviation of mesh triangles on the surface. Everything is measured in
// space against the vertices' surface normals; nothing in (u, v).
#pragma once

#include "mesh/surface_mesh.h"

namespace advlayers {

// A corner of a triangle: a point and the outward unit normal of the surface there.
struct Corner {
  Vec3 xyz;
  Vec3 normal;
};
inline Corner corner(const SurfaceMesh& mesh, VertexH v) {
  return {mesh.position(v), mesh.data(v).normal};
}

// Twice the signed area [mm^2] against the mean of the corners' normals: positive for a triangle
// that is counter-clockwise as seen from outside.
double signed_area2(const Corner& a, const Corner& b, const Corner& c);

// The smallest angle [rad]; negative where the triangle is turned over, 0 where it is a point. Its
// tangent costs less, and tells as well which of two is greater.
double min_angle_tangent(const Corner& a, const Corner& b, const Corner& c);
double min_angle(const Corner& a, const Corner& b, const Corner& c);

// Cosine of the angle between the triangle's normal and the mean of its corners' normals (paper,
// Fig. 3, with the corners standing for the projected centroid).
double deviation_cosine(const Corner& a, const Corner& b, const Corner& c);

// Cosine of the largest angle between the triangle's normal and one of its corners': a triangle
// that spans a bend may be upright on the mean, but not at its corners.
double corner_cosine(const Corner& a, const Corner& b, const Corner& c);

// The angle [rad] in 0 … 2 pi at b inside a polygon that runs counter-clockwise a, b, c.
double inner_angle(const Corner& a, const Corner& b, const Corner& c);

}  // namespace advlayers
