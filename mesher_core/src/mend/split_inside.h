// Splitting an edge of a finished mesh, whatever elements lie beside it.
#pragma once

#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

//     d --- c            d --- c
//     |     |            | \ / |
//  -> a --h-> b    ->    a--v--b      A quad beside h becomes three triangles about the new vertex,
//      \   /              \ | /       a triangle two. v is the foot of the middle of h.
//        e                  e
// The edge may be frozen, but lies inside the patch. Returns the new vertex; an invalid one where
// the surface has no foot there, and nothing was changed.
VertexH split_inside(SurfaceMesh& mesh, PatchSurface& surface, HalfedgeH h);

}  // namespace advlayers
