// The frozen result as Python sees it: CAD numbers from 1, arrays as read-only views.
#pragma once

#include <vector>

#include "mesher/result.h"

namespace advlayers::python {

struct MeshView {
  explicit MeshView(MeshResult mesh);

  MeshResult result;
  std::vector<int> quad_face, triangle_face;  // from 1
};

}  // namespace advlayers::python
