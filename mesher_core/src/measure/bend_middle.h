// Where to split an edge that the surface bends away from.
#pragma once

#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Cosine of the angle between the surface's normals at the edge's ends.
double bend_cosine(const SurfaceMesh& mesh, HalfedgeH h);

// The point half-way around the bend from one end to the other. Returns false where none is found
// at which the surface leans towards both ends by a good part of the bend less.
bool find_bend_middle(const SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h,
                      VertexData& middle);

}  // namespace advlayers
