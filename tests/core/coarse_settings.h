// Settings to begin with in tests: few elements on curved shapes, and a patch for each face.
#pragma once

#include "sizing/settings.h"

namespace advlayers::test {

inline Settings coarse_settings() {
  Settings settings;
  settings.feature_angle = 0.0;
  settings.curvature_angle = 20.0;
  return settings;
}

}  // namespace advlayers::test
