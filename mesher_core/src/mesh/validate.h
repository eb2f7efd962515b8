// Checks a mesh's connectivity and orientation. For tests, and for one check at the end of a run.
#pragma once

#include <string>

#include "mesh/surface_mesh.h"

namespace advlayers {

// Empty, or the first fault found: a broken link, a face that is neither triangle nor quad, a
// vertex whose star is no disc, a border reached by the wrong outgoing half-edge.
std::string find_connectivity_fault(const SurfaceMesh& mesh);
std::string find_connectivity_fault(const RunContext& context, const SurfaceMesh& mesh);

// Empty, or the first element that is turned over: a corner of it whose cross product points away
// from the outward normals of its vertices.
std::string find_inverted_element(const SurfaceMesh& mesh);

int euler_number(const SurfaceMesh& mesh);

}  // namespace advlayers
