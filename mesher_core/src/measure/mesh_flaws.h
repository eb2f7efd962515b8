// What a solver could not use in a finished mesh.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

struct MeshFlaws {
  // Elements of no area; those with an angle below kNeedle; vertices in the place of another one.
  std::vector<FaceH> flat, needles;
  std::vector<VertexH> coincident;
};

constexpr double kNeedle = 0.1;  // [degrees]

// Vertices are in one place where they are nearer to each other than `tolerance` [mm]. Two on the
// boundary are the shape's: it touches itself there, or has two edges in one place.
// Throws Cancelled.
MeshFlaws find_mesh_flaws(const RunContext& context, const SurfaceMesh& mesh, double tolerance);

}  // namespace advlayers
