#include "mesher/core_completion.h"

#include "core/core_collapses.h"
#include "core/fill_core.h"
#include "imprint/embed_edges.h"
#include "imprint/imprint_edges.h"
#include "measure/core_region.h"
#include "mend/inversion.h"
#include "quads/recombine.h"

namespace advlayers {

int count_inverted(const RunContext& context, const SurfaceMesh& mesh, PatchSurface& surface) {
  int inverted = 0;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    if (mesh.alive(FaceH(i)) && is_inverted(mesh, FaceH(i), surface)) ++inverted;
  }
  return inverted;
}

Completion complete_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                         Evaluator& evaluator, const Settings& settings, LayerCells cells) {
  fill_core(context, mesh, surface, evaluator, settings);
  if (settings.core == CoreElements::kQuads) recombine(context, mesh, surface, cells);
  Completion done;
  done.of_layers_mended = mend_inverted(context, mesh, surface, cells).of_layers;
  return_to_core(mesh);
  return done;
}

Completion complete_core_along_edges(const RunContext& context, SurfaceMesh& mesh,
                                     PatchSurface& surface, Evaluator& evaluator,
                                     const Discretization& boundary, const Settings& settings,
                                     LayerCells cells) {
  if (embed_edges(context, mesh, surface, evaluator, boundary) > 0) {
    prepare_core(context, mesh, surface, evaluator, settings);
  }
  const int crossing = imprint_edges(context, mesh, surface, boundary);
  collapse_slivers(context, mesh);
  Completion done = complete_core(context, mesh, surface, evaluator, settings, cells);
  done.crossing = crossing;
  return done;
}

}  // namespace advlayers
