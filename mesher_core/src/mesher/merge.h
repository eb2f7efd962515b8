// Puts the meshes of the patches together: one node per boundary node, whichever patches share it.
#pragma once

#include <vector>

#include "boundary/discretization.h"
#include "mesher/patch_job.h"
#include "mesher/result.h"

namespace advlayers {

// Nodes: those on CAD vertices and edges first, in the order of the discretization, then patch by
// patch; elements patch by patch. Boundary nodes that no meshed patch uses are left out. Fills
// the arrays, the patches' reports and the diagnostics. Throws Cancelled.
MeshResult merge(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary);

}  // namespace advlayers
