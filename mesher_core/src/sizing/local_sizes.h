// Sizes of parts that are small beside the whole: faces, and outlines inside a large face.
#pragma once

#include <vector>

#include "sizing/settings.h"

namespace advlayers {

// What `cells_across` asks for, as entries before those of the settings, which override them: each
// face has so many elements over its extent, but none finer than a tenth of the size; each small
// outline inside a plane face that is more than straight lines and arcs of circles, whose
// curvature tells all, twelve times as many around it, or fewer of many outlines.
std::vector<SizeSpec> local_sizes(const Model& model, const Settings& settings);

// The settings with those entries.
Settings with_local_sizes(const Model& model, Settings settings);

}  // namespace advlayers
