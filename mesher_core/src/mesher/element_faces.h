// Which CAD face each element of a finished patch lies on, and where its mesh could not follow
// them.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "sizing/size_field.h"

namespace advlayers {

struct ElementFaces {
  std::vector<FaceId>
      of;  // by FaceH of the mesh; of an element that reaches over edges, under its middle
  // Sorted: faces that elements reach over or stand steep beside, the smallest of those at hand,
  // and faces without an element that could hold one. Meshed on their own they would fare better.
  std::vector<FaceId> strained;
};

// Throws Cancelled.
ElementFaces find_element_faces(const RunContext& context, const SurfaceMesh& mesh,
                                PatchSurface& surface, const Discretization& boundary,
                                const SizeField& sizes);

}  // namespace advlayers
