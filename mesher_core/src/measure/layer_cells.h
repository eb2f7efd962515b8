// Which elements are of layers, and whether what finishes the mesh may change them.
#pragma once

#include "mesh/surface_mesh.h"

namespace advlayers {

// kStay: a number of layers was asked for, or that they end once isotropic; only an element that is
// turned over there is mended. kTraded: they ran until fronts met, and the last ones may be cut
// anew together with the triangles between them.
enum class LayerCells : std::uint8_t { kStay, kTraded };

// Of a layer, or between layers: one side is the base of a layer's element.
bool is_layer_cell(const SurfaceMesh& mesh, FaceH f);

}  // namespace advlayers
