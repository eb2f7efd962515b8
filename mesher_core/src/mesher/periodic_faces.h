// Periodic faces: the mesh of one, moved onto the other.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boundary/discretization.h"
#include "boundary/periodic_pairs.h"
#include "geometry/evaluator.h"
#include "mesh/surface_mesh.h"
#include "mesher/result.h"

namespace advlayers {

struct MovedMesh {
  SurfaceMesh mesh;
  std::vector<VertexH> of;  // by vertex of the given mesh: its copy
};

// The given face's mesh on the found one. None where the edges around them have different nodes, or
// a point comes to lie off the face.
std::optional<MovedMesh> move_mesh(Evaluator& evaluator, const SurfaceMesh& given,
                                   const FacePair& pair, const Discretization& boundary);

// The nodes of the finished mesh that each entry's motion brings onto others, with those.
std::vector<std::vector<std::array<int, 2>>> periodic_nodes(const RunContext& context,
                                                            const Model& model,
                                                            const Settings& settings,
                                                            const MeshResult& mesh);

}  // namespace advlayers
