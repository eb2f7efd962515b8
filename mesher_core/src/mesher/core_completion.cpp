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

void complete_core(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                   const Settings& settings) {
  improve_core(context, mesh, surface);
  if (settings.core == CoreElements::kQuads) recombine(context, mesh, surface);
  mend_inverted(context, mesh, surface);
  return_to_core(mesh);
}

int complete_core_along_edges(const RunContext& context, SurfaceMesh& mesh, PatchSurface& surface,
                              const Discretization& boundary, const Settings& settings) {
  SurfaceMesh across = mesh;
  int crossing = imprint_edges(context, mesh, surface, boundary);
  collapse_slivers(context, mesh);
  complete_core(context, mesh, surface, settings);
  if (const int inverted = count_inverted(context, mesh, surface); inverted > 0) {
    std::swap(mesh, across);
    complete_core(context, mesh, surface, settings);
    if (count_inverted(context, mesh, surface) < inverted) {
      crossing = kAllMayCross;
    } else {
      std::swap(mesh, across);
    }
  }
  return crossing;
}

}  // namespace advlayers
