// Lays the nodes of match edges where the layers of the walls at their ends come to lie.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "boundary/match_end.h"
#include "boundary/stretch.h"

namespace advlayers {

// By the walls as they are cut now. Returns notes of edges whose nodes cannot serve all layers.
std::vector<Diagnostic> run_layers_along(const RunContext& context, Evaluator& evaluator,
                                         const std::vector<MatchEnd>& match_ends,
                                         Stretches& stretches);

}  // namespace advlayers
