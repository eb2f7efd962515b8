// What a mesh will take, from the settings and the shape alone, before anything is made.
#pragma once

#include <string>

#include "base/run_context.h"
#include "geometry/model.h"
#include "sizing/settings.h"

namespace advlayers {

struct Estimate {
  double elements = 0.0;
  double megabytes = 0.0;  // of memory, beyond what the model takes
  double seconds = 0.0;    // of computing, on one processor
  std::string driver;      // the key of the setting that most of the elements are for
};

// Within a factor of some three: faces by area, curvature and size; rows of layers until they meet,
// end or are as long as wide; the transition from short segments and from points of refinement,
// which takes the logarithm of how fine they are. Throws Cancelled, and InvalidInput as Mesher
// does.
Estimate estimate(const RunContext& context, const Model& model, const Settings& settings);

}  // namespace advlayers
