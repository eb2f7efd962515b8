// Edges of different patches that would be one in the merged mesh.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "mesher/patch_job.h"

namespace advlayers {

// Two patches may each join the same two boundary nodes by an edge of its own, as across the bend
// of an arc that they share, and so may the two sides of a slit: one edge with four elements once
// the patches are merged. All but the first get a vertex in their middle, and so does every edge
// inside a patch that joins neighbours on a boundary. Throws Cancelled.
void part_doubled_edges(const RunContext& context, const PatchJobs& jobs,
                        const Discretization& boundary);

}  // namespace advlayers
