// The last look at a triangulation: is every triangle on its side of the surface, and near enough?
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

struct Deviations {
  std::vector<Diagnostic> diagnostics;
  // Sorted: of the border about triangles that are turned over.
  std::vector<EdgeId> edges_of_inverted;
};

// Diagnostics: "triangulation-inverted" (error) and "triangulation-deviates" (warning), each once
// for every CAD face that has such triangles, at the worst of them, with their number.
Deviations check_deviation(const RunContext& context, const SurfaceMesh& mesh,
                           PatchSurface& surface);

}  // namespace advlayers
