#include "mesher/core_completion.h"

#include <utility>

#include "core/core_collapses.h"
#include "core/core_improvement.h"
#include "imprint/imprint_edges.h"
#include "measure/core_region.h"
#include "mend/inversion.h"
#include "quads/recombine.h"

namespace advlayers {
namespace {

int count_inverted(const RunContext& context, const SurfaceMesh& mesh, PatchSurface& surface) {
  int inverted = 0;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    if (mesh.alive(FaceH(i)) && is_inverted(mesh, FaceH(i), surface)) ++inverted;
  }
  return inverted;
}

}  // namespace

Completion complete_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                         const Settings& settings, LayerCells cells) {
  improve_core(context, mesh, surface);
  if (settings.core == CoreElements::kQuads) recombine(context, mesh, surface, cells);
  Completion done;
  done.of_layers_mended = mend_inverted(context, mesh, surface, cells).of_layers;
  return_to_core(mesh);
  return done;
}

Completion complete_core_along_edges(const RunContext& context, SurfaceMesh& mesh,
                                     PatchSurface& surface, const Discretization& boundary,
                                     const Settings& settings, LayerCells cells) {
  SurfaceMesh across = mesh.copy(context);
  const int crossing = imprint_edges(context, mesh, surface, boundary);
  collapse_slivers(context, mesh);
  Completion done = complete_core(context, mesh, surface, settings, cells);
  done.crossing = crossing;
  if (const int inverted = count_inverted(context, mesh, surface); inverted > 0) {
    std::swap(mesh, across);
    Completion other = complete_core(context, mesh, surface, settings, cells);
    if (count_inverted(context, mesh, surface) < inverted) {
      done = other;
      done.crossing = kAllMayCross;
    } else {
      std::swap(mesh, across);
    }
  }
  return done;
}

}  // namespace advlayers
