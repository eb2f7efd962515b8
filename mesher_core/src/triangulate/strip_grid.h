// A face with four sides as a grid: as many segments on facing sides, and nodes that face each
// other.
#pragma once

#include <optional>
#include <vector>

#include "boundary/discretization.h"
#include "geometry/four_sides.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

class StripGrid {
 public:
  // Places the points inside between those of the boundary, by transfinite interpolation in (u, v).
  // None where facing sides are cut into different numbers of segments, or the boundary touches
  // itself at a node.
  static std::optional<StripGrid> lay_out(const RunContext& context, Evaluator& evaluator,
                                          const Discretization& boundary, const FourSides& face);

  int columns() const { return columns_; }  // of quads, along the long sides 0 and 2
  int rows() const { return rows_; }        // and across
  // Row 0 is the face's side 0, column 0 its side 3. The same point, by its node, where a seam
  // closes the grid.
  const VertexData& at(int column, int row) const { return points_[index(column, row)]; }
  // Length of a column [mm], and that of the way straight across, where it is slanted.
  double length(int column) const;
  double width(int column) const;
  // The largest angle [rad] by which the surface turns over a step of a column.
  double turn_across(int column) const;

  // Quads of layer 0; border edges are frozen and name their CAD edge.
  SurfaceMesh mesh() const;

 private:
  struct BoundaryPoint {
    NodeId node;
    Vec2 uv;
    Vec3 xyz;
    Support support;
    EdgeId edge;  // that goes on from here along the loop
    bool seam;    // which is one
  };
  using Side = std::vector<BoundaryPoint>;  // ends included

  static Side points_along(Evaluator& evaluator, const Discretization& boundary, FaceId face,
                           const std::vector<CoEdge>& coedges);
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
           static_cast<std::size_t>(column);
  }
  bool meets_itself() const;
  void place_points(const RunContext& context, Evaluator& evaluator, FaceId face);
  std::vector<VertexH> add_vertices(SurfaceMesh& mesh) const;
  void mark_border(SurfaceMesh& mesh, const std::vector<VertexH>& vertices) const;

  int columns_ = 0, rows_ = 0;
  std::array<Side, 4> sides_;  // 0 and 1 along the loop, 2 and 3 against it
  std::vector<VertexData> points_;
};

}  // namespace advlayers
