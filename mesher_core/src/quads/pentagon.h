// The pentagon that a triangle makes with a quad beside it, and the five ways to cut it into a
// triangle and a quad.
//
//    p ----- b ----- c
//     \      |       |         (a, b) is the edge between the triangle (a, b, p) and the quad
//       \    |       |         (a, d, c, b)
//         \  |       |
//            a ----- d
#pragma once

#include <array>

#include "mesh/surface_mesh.h"

namespace advlayers {

struct Pentagon {
  VertexH p, a, d, c, b;
};

// By the corner of the pentagon that the triangle takes; kP is how it is cut already.
enum class PentagonCut : std::uint8_t { kP, kA, kB, kC, kD };

struct PentagonHalves {
  std::array<VertexH, 3> triangle;
  std::array<VertexH, 4> quad;
};

// The pentagon of the triangle left of `shared` and the quad right of it, if p is the third vertex
// of the triangle.
Pentagon pentagon_at(const SurfaceMesh& mesh, HalfedgeH shared, VertexH p);
PentagonHalves halves_of(const Pentagon& pentagon, PentagonCut cut);

// Cuts the pentagon anew; `shared` and the diagonals change. Returns false, with the mesh and its
// handles as before, where its topology forbids.
bool recut(SurfaceMesh& mesh, HalfedgeH shared, PentagonCut cut);

}  // namespace advlayers
