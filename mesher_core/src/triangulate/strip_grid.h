// A face with four sides as a grid: as many segments on facing sides, and nodes that face each
// other.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "boundary/discretization.h"
#include "geometry/four_sides.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

class StripGrid {
 public:
  struct BoundaryPoint {
    NodeId node;
    Vec2 uv;
    Vec3 xyz;
    Support support;
    EdgeId edge;  // that goes on from here along the loop
    bool seam;    // which is one
  };
  // Ends included; sides 0 and 1 run along the loop, 2 and 3 against it.
  using Side = std::vector<BoundaryPoint>;

  // Places the points inside between those of the boundary, by transfinite interpolation in (u, v).
  // None where facing sides are cut into different numbers of segments, or the boundary touches
  // itself at a node.
  static std::optional<StripGrid> lay_out(const RunContext& context, Evaluator& evaluator,
                                          const Discretization& boundary, const FourSides& face);

  // The same of a ring, whose sides 0 and 2 are its two rims, without others between them: column 0
  // follows the last one. Nodes of the rims are paired where the columns come out shortest.
  // `rows` are the shares of the way across at which they lie, for a mean width [mm].
  using Rows = std::function<std::vector<double>(const Side& low, double width)>;
  static std::optional<StripGrid> lay_out_ring(const RunContext& context, Evaluator& evaluator,
                                               const Discretization& boundary,
                                               const FourSides& face, const Rows& rows);

  bool ring() const { return ring_; }
  int columns() const { return columns_; }  // of quads, along the long sides 0 and 2
  int rows() const { return rows_; }        // and across
  // Row 0 is the face's side 0, column 0 its side 3. The same point, by its node, where a seam
  // closes the grid.
  const VertexData& at(int column, int row) const { return points_[index(column, row)]; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(column);
  }
  const Side& side(int k) const { return sides_[static_cast<std::size_t>(k)]; }
  // Moves a point inside the grid.
  void place(int column, int row, const SurfacePoint& point, const Vec3& normal);
  // Length of a column [mm], and that of the way straight across, where it is slanted.
  double length(int column) const;
  double width(int column) const;
  // The largest angle [rad] by which the surface turns over a step of a column.
  double turn_across(int column) const;

  // Quads of layer 0; border edges are frozen and name their CAD edge. `vertices`, where given,
  // are those of the points, row after row.
  SurfaceMesh mesh(std::vector<VertexH>* vertices = nullptr) const;

 private:
  static Side points_along(Evaluator& evaluator, const Discretization& boundary, FaceId face,
                           const std::vector<CoEdge>& coedges);
  bool meets_itself() const;
  void place_points(const RunContext& context, Evaluator& evaluator, FaceId face);
  std::vector<VertexH> add_vertices(SurfaceMesh& mesh) const;
  void mark_border(SurfaceMesh& mesh, const std::vector<VertexH>& vertices) const;

  static double pair_rims(const RunContext& context, const Side& low, Side& high);
  void place_between_rims(Evaluator& evaluator, FaceId face, const std::vector<double>& shares);

  int columns_ = 0, rows_ = 0;
  bool ring_ = false;
  std::array<Side, 4> sides_;
  std::vector<VertexData> points_;
};

}  // namespace advlayers
