// Settings and results of a sewn model in the names of the shape as it was given.
#pragma once

#include "mesher/result.h"
#include "sizing/settings.h"

namespace advlayers {

// The settings with every edge of the given shape replaced by what it is in the model.
Settings in_edges_of(const Model& model, Settings settings);

// The mesh edges of every edge of the given shape are those of what it became. A piece of an edge
// that has no name of its own is reported under that of the whole.
void name_given_edges(const Model& model, MeshResult& result);

}  // namespace advlayers
