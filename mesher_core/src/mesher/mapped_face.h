// Mapped faces: rows and columns of quads from side to side, with the layers of the walls along the
// sides.
#pragma once

#include <optional>
#include <vector>

#include "base/run_context.h"
#include "boundary/discretization.h"
#include "boundary/match_end.h"
#include "geometry/four_sides.h"
#include "geometry/patch_surface.h"
#include "layers/patch_layers.h"
#include "layers/wall_plan.h"
#include "mesh/surface_mesh.h"
#include "sizing/settings.h"

namespace advlayers {

// The sides of a face that may be mapped: four, or the two rims of a ring in a plane for sides 0
// and 2, without others between them.
std::optional<FourSides> find_mapped_sides(Evaluator& evaluator, FaceId face);

// Where the layers of walls along mapped sides meet the sides beside them: these are cut as match
// edges are, whatever grows from them.
std::vector<MatchEnd> ends_of_mapped(Evaluator& evaluator, const FourSides& sides,
                                     const WallPlan& walls);

struct MappedMesh {
  SurfaceMesh mesh;
  int layers = 0;                 // of the wall that has most
  std::vector<StopRecord> stops;  // of its columns
};

// None where facing sides have different numbers of segments, or an element would be turned over,
// fold, or leave the surface. `size`: across a ring, which has no edge that says it [mm].
std::optional<MappedMesh> mesh_mapped(const RunContext& context, Evaluator& evaluator,
                                      PatchSurface& surface, const Discretization& boundary,
                                      const FourSides& sides, const WallPlan& walls, double size);

// Whether a mesh of a face that nobody asked to map does as well as any other there: near to right
// angles, and near to the size everywhere.
bool fits(const RunContext& context, Evaluator& evaluator, PatchSurface& surface,
          const SurfaceMesh& mesh, const Settings& settings);

}  // namespace advlayers
