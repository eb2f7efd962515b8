// Cuts a polygon of mesh vertices into triangles and quads, such that no piece reaches from one CAD
// face to another.
#pragma once

#include <vector>

#include "imprint/face_sides.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

struct PolygonPieces {
  std::vector<std::vector<VertexH>> polygons;  // of three or four corners
  double quality = 1.0;                        // of the worst piece; see element_measures.h
  bool parted = true;                          // false: a piece reaches over an edge of the model
};

// `corners` counter-clockwise, three or more; up to nine are cut as well as they can be. With
// `triangles` no quad is made.
PolygonPieces cut_polygon(const SurfaceMesh& mesh, const FaceSides& sides,
                          const std::vector<VertexH>& corners, bool triangles);

}  // namespace advlayers
