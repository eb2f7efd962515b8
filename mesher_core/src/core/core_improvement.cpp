#include "core/core_improvement.h"

#include "core/core_flips.h"
#include "core/core_splits.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"

namespace advlayers {
namespace {

constexpr int kRounds = 3;          // of flips, splits and smoothing
constexpr int kSweepsPerRound = 3;  // of smoothing

}  // namespace

void improve_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface) {
  if (split_bent_edges(context, mesh, surface) > 0) flip_core(context, mesh);
  const std::vector<VertexH> free = free_vertices(mesh);
  for (int round = 0; round < kRounds; ++round) {
    flip_core(context, mesh);
    smooth_stars(context, mesh, surface, free, QuadTarget::kSquare, kSweepsPerRound);
  }
}

}  // namespace advlayers
