// Brings the model's edges inside a patch of several faces into its finished layers: nodes move
// onto them or are added, and what they cross is cut, so that every element lies on one CAD face.
#pragma once

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

// Vertices keep their handles; faces and edges get new ones. The mesh edges on inner edges are
// frozen and name their CAD edge, and their vertices have Support::kEdge, or kVertex, and no node.
// Returns the number of elements that still reach from one face to another. Throws Cancelled.
int imprint_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  const Discretization& boundary);

}  // namespace advlayers
