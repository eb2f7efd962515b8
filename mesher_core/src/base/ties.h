// Ties between figures that are equal but for round-off. Where the greater wins and equal ones go
// by the order of the mesh, a shape that is turned, moved, scaled or mirrored gets the same mesh.
#pragma once

namespace advlayers {

// The figure to single precision: what symmetry makes equal compares equal.
inline double settled(double figure) { return static_cast<double>(static_cast<float>(figure)); }

}  // namespace advlayers
