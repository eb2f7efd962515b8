#include "core/core_improvement.h"

#include "core/core_flips.h"
#include "core/core_splits.h"
#include "core/star_smoothing.h"
#include "measure/core_region.h"

namespace advlayers {
namespace {

constexpr int kRounds = 3;
constexpr int kSweepsPerRound = 3;

}  // namespace

void improve_core(SurfaceMesh& mesh, PatchSurface& surface, const CancelFlag& cancel) {
  if (split_bent_edges(mesh, surface, cancel) > 0) flip_core(mesh, cancel);
  const std::vector<VertexH> free = free_vertices(mesh);
  for (int round = 0; round < kRounds; ++round) {
    flip_core(mesh, cancel);
    smooth_stars(mesh, surface, free, QuadTarget::kSquare, kSweepsPerRound, cancel);
  }
}

}  // namespace advlayers
