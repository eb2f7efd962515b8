// Which faces are meshed together, and what grows from each of their boundary edges: the
// settings, resolved against the model.
#pragma once

#include <string>
#include <vector>

#include "geometry/model.h"
#include "layers/wall_plan.h"
#include "sizing/settings.h"

namespace advlayers {

struct PatchPlan {
  std::vector<FaceId> faces;
  WallPlan walls;
};

// One plan per patch, ordered by the patch's first face. Every face asked for is in exactly one.
std::vector<PatchPlan> plan_patches(const Model& model, const Settings& settings);

// "Face3", or "Face3 and 4 more" for a patch of several.
std::string patch_name(const std::vector<FaceId>& faces);

}  // namespace advlayers
