// Moves vertices, one at a time, to where the elements about them come nearest to their ideal
// shape: right angles for quads, equal sides for triangles.
//
// An element corner with sides e1, e2 costs f = (w1 |e1|^2 + w2 |e2|^2) / (2 |e1 x e2|) >= 1 with
// w1 w2 = 1, which grows without bound as the corner closes or opens flat: a valid mesh stays
// valid. In the tangent plane f is a square over a linear form, hence convex, and a few Newton
// steps find the minimum of the sum (of squares, so that the worst corner counts most).
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// What a quad is to become: a square (w1 = w2 = 1), or a rectangle of the sides it has now.
enum class QuadTarget { kSquare, kRectangle };

// Sweeps until no vertex moves by more than a small part of its edges' length, at most `sweeps`
// times. A move that would fold a face is not made. Throws Cancelled.
void smooth_stars(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const std::vector<VertexH>& movable, QuadTarget target, int sweeps);

// True where with v at `place` every face about it stays on the surface's outer side, and turns the
// same way at each of its corners.
bool keeps_faces_upright(const SurfaceMesh& mesh, VertexH v, const Vec3& place);

}  // namespace advlayers
