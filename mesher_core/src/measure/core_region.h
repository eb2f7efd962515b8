// What of a patch's mesh belongs to the core: the faces that no layer has reached, and the
// vertices inside it that may move. Fronts, parent-kid edges and the CAD's boundary stay.
#pragma once

#include <vector>

#include "mesh/surface_mesh.h"

namespace advlayers {

// True where the vertex lies inside the patch, among core faces only, on no frozen edge.
bool is_free(const SurfaceMesh& mesh, VertexH v);

// The core's free vertices in the order of their handles.
std::vector<VertexH> free_vertices(const SurfaceMesh& mesh);

// Front vertices where fronts have met: beside a core face without a free vertex, and above the
// layers whose heights are to stay as extruded. In the order of their handles.
std::vector<VertexH> seam_vertices(const SurfaceMesh& mesh);

inline bool is_core(const SurfaceMesh& mesh, FaceH f) { return mesh.data(f).layer == 0; }

// Both faces beside the edge belong to the core, and the edge may be changed.
bool is_core_edge(const SurfaceMesh& mesh, HalfedgeH h);

// True where one end of the mesh edge was extruded from the other.
bool is_extrusion(const SurfaceMesh& mesh, HalfedgeH h);

// A quad counts as one of a layer only where a parent-kid edge bounds it: the others, which closing
// fronts left, are given to the core.
void return_to_core(SurfaceMesh& mesh);

}  // namespace advlayers
