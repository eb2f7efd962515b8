// The initial isotropic triangulation of a patch (paper, III): boundary kept as it is, interior by
// size and curvature, every triangle within the angle bound of the exact surface.
#pragma once

#include <vector>

#include "base/cancel.h"
#include "base/diagnostic.h"
#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

struct Triangulation {
  // All triangles, layer 0. Every border edge is frozen and names its CAD edge. A boundary node
  // where the border touches itself becomes one vertex per touching run, with the same NodeId.
  SurfaceMesh mesh;
  std::vector<Diagnostic> diagnostics;
};

// Throws GeometryError naming the face where no valid triangulation is found.
Triangulation triangulate(PatchSurface& surface, Evaluator& evaluator,
                          const Discretization& boundary, const Settings& settings,
                          const CancelFlag& cancel);

}  // namespace advlayers
