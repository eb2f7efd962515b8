// The best triangulation of a small polygon, by a cost of each triangle.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "mesh/surface_mesh.h"

namespace advlayers {

// Cuts the polygon, counter-clockwise and of three corners or more, into triangles whose costs have
// the least sum. Costs of n^3 / 6 triangles are asked for.
std::vector<std::vector<VertexH>> cheapest_triangles(
    const std::vector<VertexH>& polygon,
    const std::function<double(const std::array<VertexH, 3>&)>& cost);

}  // namespace advlayers
