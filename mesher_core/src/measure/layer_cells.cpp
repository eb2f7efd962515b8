#include "measure/layer_cells.h"

namespace advlayers {

bool is_layer_cell(const SurfaceMesh& mesh, FaceH f) {
  if (mesh.data(f).layer > 0) return true;
  for (const HalfedgeH h : mesh.sides(f)) {
    const HalfedgeH beyond = SurfaceMesh::twin(h);
    if (!mesh.is_border(beyond)) {
      const int layer = mesh.data(mesh.face(beyond)).layer;
      const int lower = mesh.data(mesh.from(h)).layer, other = mesh.data(mesh.to(h)).layer;
      // Vertices of the border count as of no layer.
      if (layer > 1 && lower == layer - 1 && other == layer - 1) return true;
    }
  }
  return false;
}

}  // namespace advlayers
