// Puts the model's edges inside a patch of several faces into its core as they are cut everywhere:
// with their own nodes, evenly spaced.
#pragma once

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// The nodes that lie in the core, clear of its border, become vertices with Support::kEdge, or
// kVertex, and no node; the mesh edges between neighbours are frozen and name their CAD edge.
// Returns how many of these are not to be had: they are left to imprint_edges(). Throws Cancelled.
int embed_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                Evaluator& evaluator, const Discretization& boundary);

}  // namespace advlayers
