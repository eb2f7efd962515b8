// Trouble on one patch is data, not an exception: the patch keeps its last valid mesh.
#pragma once

#include <string>

#include "base/sentence.h"
#include "base/types.h"

namespace advlayers {

enum class Severity { kInfo, kWarning, kError };

struct Diagnostic {
  Severity severity = Severity::kWarning;
  std::string code;  // stable, in kebab-case: "front-blocked"
  PatchId patch;     // invalid: the whole model
  int layer = 0;     // 0: not in a layer
  Vec3 point = Vec3::Zero();
  Sentence sentence;  // names the CAD entity and the value
};

}  // namespace advlayers
