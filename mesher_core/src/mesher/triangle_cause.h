// Why a finished mesh has the triangles that it has, read off where they lie.
#pragma once

#include <map>
#include <string>

#include "mesh/surface_mesh.h"

namespace advlayers {

// Cause -> triangles of the mesh:
//   collapse    in a layer: two nodes of the front shared a kid there, so it lost an edge
//   step        in the core, beside a parent-kid edge: one column ended before its neighbour
//   closing     between layers, where an event (tip, zip, row end) shortened the front
//   last loop   in a rest of at most six core elements that fronts or borders enclose
//   collision   in a larger rest where fronts met and left no vertex that could move
//   core        beside a vertex of the core: none of its neighbours made a good quad with it
std::map<std::string, int> triangle_causes(const RunContext& context, const SurfaceMesh& mesh);

}  // namespace advlayers
