// What is said of walls whose layers begin at other heights than asked for.
#pragma once

#include <vector>

#include "base/sentence.h"
#include "mesher/result.h"

namespace advlayers {

// One sentence for all such walls of a patch, the worst first: a faceted arc is many edges.
Sentence missed_heights(std::vector<const WallReport*> walls);

}  // namespace advlayers
