// Makes a finished mesh one of second order: a node in the middle of each mesh edge, on the CAD.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "mesher/patch_job.h"
#include "mesher/result.h"

namespace advlayers {

// `result` is the merged mesh of the jobs. Mid nodes on borders come first, then patch by patch.
// Where a curved element would be turned over at a node, mid nodes are drawn back, step by step,
// until it is not; a diagnostic tells of it. Throws Cancelled.
void add_mid_nodes(const RunContext& context, const PatchJobs& jobs, const Discretization& boundary,
                   const Settings& settings, unsigned threads, const Model& model,
                   MeshResult& result);

// Fills the mid nodes of the segments on CAD edges, whichever edges they are listed for.
void find_segment_mids(MeshResult& result);

}  // namespace advlayers
