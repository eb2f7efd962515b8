// Brings triangles that stayed alone together: a triangle walks across quads, each time taking a
// corner of the pentagon that it forms with the next quad and leaving a quad behind, until it
// meets another triangle and both become a quad.
//
//    p ----- b ----- c        p ----- b ----- c
//     \      |       |         \            / |
//       \    |   Q   |   ->      \    quad /  |       the triangle has walked over (a, b)
//         \  |       |             \      / T |       from (a, b, p) to (a, d, c)
//            a ----- d               a ----- d
#pragma once

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Joins core triangles over at most a few quads each, nearest first. Every quad on the way keeps
// corners that smoothing can open. Two ends of rows that lie in line, where no other triangle is
// near, become a quad as well: the free vertex between them is moved out of the line. All other
// positions stay. Returns the number of pairs made. Throws Cancelled.
int join_triangles(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface);

}  // namespace advlayers
