// What there is to say of a run as a whole, once its patches are finished.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "geometry/model.h"
#include "mesher/patch_job.h"
#include "sizing/settings.h"

namespace advlayers {

// A wall that was asked for by name, but grows nowhere, is not passed over in silence.
void note_idle_walls(const Settings& settings, const PatchJobs& jobs,
                     std::vector<Diagnostic>& diagnostics);
// How many nodes of an initial mesh the triangulations took.
void note_initial_mesh(const Settings& settings, const PatchJobs& jobs,
                       std::vector<Diagnostic>& diagnostics);
// What sewing joined, and what it left open.
void note_sewing(const Model& model, std::vector<Diagnostic>& diagnostics);

}  // namespace advlayers
