// Moves the core's free vertices, one at a time, to where the elements about them come nearest to
// their ideal shape: right angles with equal sides for quads, equal sides for triangles.
//
// An element corner with sides e1, e2 costs f = (|e1|^2 + |e2|^2) / (2 |e1 x e2|) >= 1, which
// grows without bound as the corner closes or opens flat: a valid mesh stays valid. In the tangent
// plane f is a square over a linear form, hence convex, and a few Newton steps find the minimum
// of the sum (of squares, so that the worst corner counts most).
#pragma once

#include <vector>

#include "base/cancel.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Sweeps until no vertex moves by more than a small part of its edges' length, at most `sweeps`
// times. A move that would fold a face is not made. Throws Cancelled.
void smooth_stars(SurfaceMesh& mesh, PatchSurface& surface, const std::vector<VertexH>& free,
                  int sweeps, const CancelFlag& cancel);

// One vertex; true where it moved noticeably.
bool smooth_star(SurfaceMesh& mesh, PatchSurface& surface, VertexH v);

}  // namespace advlayers
