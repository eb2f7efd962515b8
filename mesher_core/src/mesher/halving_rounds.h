// Triangulates the patches of a run, in rounds between which CAD edges are cut finer.
#pragma once

#include "boundary/discretization.h"
#include "mesher/job_list.h"

namespace advlayers {

// Triangulates the patches that are not meshed. Where the boundary turns out to be cut too coarsely
// for a face, its edges are halved until it is not. A face that stays so however finely its edges
// are cut (they cross each other) is given up, and no edge is halved for its sake: its neighbours
// would pay for it. Patches beside an edge that stays halved are triangulated anew, so that all fit
// `boundary` afterwards. Periodic edges are halved together. Throws Cancelled.
void triangulate_in_rounds(const RunContext& context, const Model& model, JobList& list,
                           const std::vector<EdgePair>& periodic, Discretization& boundary);

}  // namespace advlayers
