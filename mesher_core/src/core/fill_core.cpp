#include "core/fill_core.h"

#include "core/core_field.h"
#include "core/core_flips.h"
#include "core/core_room.h"
#include "core/core_splits.h"
#include "core/place_points.h"
#include "core/refine_room.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"

namespace advlayers {
namespace {

// Edges of what the fields are found on, and of what edges of the model are cut into, in those of
// the elements to come.
constexpr double kBackgroundLength = 5.0;
constexpr double kCutLength = 1.15;
// Of smoothing, where no squares are to come.
constexpr int kRounds = 3;
constexpr int kSweepsPerRound = 3;

}  // namespace

void prepare_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                  Evaluator& evaluator, const Settings& settings) {
  TargetSize target(evaluator, settings);
  refine_room(context, mesh, surface, target, kCutLength);
}

void fill_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
               Evaluator& evaluator, const Settings& settings) {
  const int arms = settings.core == CoreElements::kQuads ? 4 : 6;
  TargetSize target(evaluator, settings);
  refine_room(context, mesh, surface, target, kBackgroundLength);
  const CoreRoom room = find_core_room(mesh);
  CoreField field = find_core_field(context, mesh, room, arms, target);
  place_points(context, mesh, surface, room, target, field);
  if (split_bent_edges(context, mesh, surface) > 0) flip_core(context, mesh);
  if (arms == 4) return;
  const std::vector<VertexH> free = free_vertices(mesh);
  for (int round = 0; round < kRounds; ++round) {
    flip_core(context, mesh);
    smooth_stars(context, mesh, surface, free, QuadTarget::kSquare, kSweepsPerRound);
  }
}

}  // namespace advlayers
