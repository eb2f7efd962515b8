// Edges and faces that a motion brings onto others: what is to be cut and meshed alike.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/evaluator.h"
#include "sizing/settings.h"

namespace advlayers {

using Motion = Eigen::Isometry3d;

struct EdgePair {
  EdgeId given, found;
  bool reversed = false;  // the motion brings the first parameter of one onto the last of the other
  Motion motion;
};

struct FacePair {
  FaceId given, found;
  Motion motion;
  std::vector<EdgePair> edges;  // around them; an edge that stays where it is pairs with itself
};

struct PeriodicPairs {
  std::vector<EdgePair> edges;  // none with itself; those of faces, too
  std::vector<FacePair> faces;
};

Motion motion_of(const PeriodicSpec& spec);

// What lies where the entry's edges and faces come to lie. Throws InvalidInput naming the first for
// which there is nothing.
PeriodicPairs find_periodic(const RunContext& context, const Model& model,
                            const PeriodicSpec& spec);
// Of all entries.
PeriodicPairs find_periodic(const RunContext& context, const Model& model,
                            const Settings& settings);

}  // namespace advlayers
