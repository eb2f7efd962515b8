#include "core/core_field.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "core/core_sizes.h"
#include "core/cross_directions.h"

namespace advlayers {

Cross CoreField::between(const std::array<VertexH, 3>& corners, const std::array<double, 3>& shares,
                         const Vec3& normal) const {
  using Complex = std::complex<double>;
  // Seen from the nearest corner, so that it is the same from either side of an edge.
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    const double share = settled(shares[k]), most = settled(shares[nearest]);
    if (share > most || (share == most && corners[k] < corners[nearest])) nearest = k;
  }
  const Vec3& first = at(corners[nearest]).along;
  const Vec3 x = (first - first.dot(normal) * normal).normalized(), y = normal.cross(x);
  Complex sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Cross& corner = at(corners[k]);
    const Complex z(corner.along.dot(x), corner.along.dot(y));
    const Complex square = z * z / std::max(std::norm(z), 1e-300);
    sum += shares[k] * corner.weight * square * square * (arms_ == 6 ? square : 1.0);
  }
  Cross cross;
  cross.weight = std::abs(sum);
  const double angle = std::arg(sum) / arms_;
  cross.along = std::cos(angle) * x + std::sin(angle) * y;
  for (std::size_t k = 0; k < 3; ++k) {
    const Cross& corner = at(corners[k]);
    const bool swapped = cross.is_across(corner.along, normal);
    cross.size_along += shares[k] * (swapped ? corner.size_across : corner.size_along);
    cross.size_across += shares[k] * (swapped ? corner.size_along : corner.size_across);
  }
  return cross;
}

CoreField find_core_field(const RunContext& context, const SurfaceMesh& mesh, const CoreRoom& room,
                          int arms, TargetSize& target) {
  const std::vector<CrossDirection> directions = find_cross_directions(context, mesh, room, arms);
  const std::vector<CrossSizes> sizes = find_core_sizes(mesh, room, directions, arms, target);
  std::vector<Cross> crosses(mesh.vertex_capacity());
  for (std::size_t k = 0; k < room.vertices.size(); ++k) {
    Cross& cross = crosses[room.vertices[k].index()];
    cross.along = directions[k].along;
    cross.weight = directions[k].weight;
    cross.size_along = sizes[k][0];
    cross.size_across = sizes[k][1];
  }
  return {std::move(crosses), arms};
}

}  // namespace advlayers
