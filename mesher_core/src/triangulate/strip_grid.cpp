#include "triangulate/strip_grid.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/directions.h"

namespace advlayers {
namespace {

// Shares of the length along a row of points, from 0 to 1.
template <class Points>
std::vector<double> shares_along(const Points& points) {
  std::vector<double> shares{0.0};
  for (std::size_t k = 1; k < points.size(); ++k) {
    shares.push_back(shares.back() + (points[k].xyz - points[k - 1].xyz).norm());
  }
  const double length = shares.back();
  for (double& share : shares) share /= length;
  return shares;
}

}  // namespace

StripGrid::Side StripGrid::points_along(Evaluator& evaluator, const Discretization& boundary,
                                        FaceId face, const std::vector<CoEdge>& coedges) {
  Side side;
  for (const CoEdge& coedge : coedges) {
    const EdgeNodes& cut = boundary.edges[coedge.edge.index()];
    const std::size_t count = cut.nodes.size();
    if (!side.empty()) side.pop_back();  // the joint belongs to the edge that goes on
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = coedge.forward ? k : count - 1 - k;
      const BoundaryNode& node = boundary.nodes[cut.nodes[i].index()];
      side.push_back({cut.nodes[i], evaluator.edge_uv(face, coedge, cut.params[i]), node.xyz,
                      node.vertex.valid() ? Support::kVertex : Support::kEdge, coedge.edge,
                      coedge.seam});
    }
  }
  return side;
}

std::optional<StripGrid> StripGrid::lay_out(const RunContext& context, Evaluator& evaluator,
                                            const Discretization& boundary, const FourSides& face) {
  StripGrid grid;
  for (std::size_t k = 0; k < 4; ++k) {
    grid.sides_[k] = points_along(evaluator, boundary, face.face, face.sides[k]);
  }
  if (grid.sides_[0].size() != grid.sides_[2].size()) return std::nullopt;
  if (grid.sides_[1].size() != grid.sides_[3].size() || grid.meets_itself()) return std::nullopt;
  std::reverse(grid.sides_[2].begin(), grid.sides_[2].end());
  std::reverse(grid.sides_[3].begin(), grid.sides_[3].end());
  grid.columns_ = static_cast<int>(grid.sides_[0].size()) - 1;
  grid.rows_ = static_cast<int>(grid.sides_[1].size()) - 1;
  grid.place_points(context, evaluator, face.face);
  return grid;
}

std::optional<StripGrid> StripGrid::lay_out_ring(const RunContext& context, Evaluator& evaluator,
                                                 const Discretization& boundary,
                                                 const FourSides& face, const Rows& rows) {
  StripGrid grid;
  grid.ring_ = true;
  Side& low = grid.sides_[0] = points_along(evaluator, boundary, face.face, face.sides[0]);
  Side& high = grid.sides_[2] = points_along(evaluator, boundary, face.face, face.sides[2]);
  if (low.size() != high.size() || grid.meets_itself()) return std::nullopt;
  std::reverse(high.begin(), high.end());
  const double width = pair_rims(context, low, high);
  const std::vector<double> shares = rows(low, width);
  grid.columns_ = static_cast<int>(low.size()) - 1;
  grid.rows_ = static_cast<int>(shares.size()) - 1;
  grid.place_between_rims(evaluator, face.face, shares);
  return grid;
}

// Turns the upper rim; returns the mean length of a column [mm].
double StripGrid::pair_rims(const RunContext& context, const Side& low, Side& high) {
  const std::size_t count = low.size() - 1;  // the last point is the first
  high.erase(high.begin());  // the other one knows the edge that the loop begins with
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t offset = 0; offset < count; ++offset) {
    context.check();
    double sum = 0.0;
    for (std::size_t k = 0; k < count && sum < least; ++k) {
      sum += (low[k].xyz - high[(k + offset) % count].xyz).norm();
    }
    if (sum < least) {
      least = sum;
      best = offset;
    }
  }
  std::rotate(high.begin(), high.begin() + static_cast<std::ptrdiff_t>(best), high.end());
  high.push_back(high.front());
  return least / static_cast<double>(count);
}

void StripGrid::place_between_rims(Evaluator& evaluator, FaceId face,
                                   const std::vector<double>& shares) {
  points_.resize(index(columns_, rows_) + 1);
  for (int row = 0; row <= rows_; ++row) {
    const double up = shares[static_cast<std::size_t>(row)];
    for (int column = 0; column <= columns_; ++column) {
      const auto c = static_cast<std::size_t>(column);
      const BoundaryPoint &low = sides_[0][c], &high = sides_[2][c];
      const Vec2 uv = (1.0 - up) * low.uv + up * high.uv;
      const SurfaceFrame frame = evaluator.frame(face, uv.x(), uv.y());
      VertexData& data = points_[index(column, row)];
      data.point = {face, uv.x(), uv.y(), frame.xyz};
      data.normal = frame.normal;
      if (row > 0 && row < rows_) continue;
      const BoundaryPoint& on = row == 0 ? low : high;
      data.point.xyz = on.xyz;
      data.node = on.node;
      data.support = on.support;
    }
  }
}

// But for a seam, which closes a band.
bool StripGrid::meets_itself() const {
  std::set<NodeId> nodes;
  std::size_t points = 0;
  for (const Side& side : sides_) {
    for (std::size_t k = 0; k + 1 < side.size(); ++k) nodes.insert(side[k].node);
    points += std::max<std::size_t>(side.size(), 1) - 1;
  }
  for (const std::size_t k : {0, 1}) {
    if (ring_) break;
    if (sides_[k].front().seam) points -= sides_[k].size();
  }
  return nodes.size() != points;
}

void StripGrid::place_points(const RunContext& context, Evaluator& evaluator, FaceId face) {
  const auto& [low, right, high, left] = sides_;
  const std::vector<double> along_low = shares_along(low), along_high = shares_along(high);
  const std::vector<double> up_left = shares_along(left), up_right = shares_along(right);
  points_.resize(index(columns_, rows_) + 1);
  for (int row = 0; row <= rows_; ++row) {
    context.check();
    const auto r = static_cast<std::size_t>(row);
    for (int column = 0; column <= columns_; ++column) {
      const auto c = static_cast<std::size_t>(column);
      VertexData& data = points_[index(column, row)];
      const BoundaryPoint* on = row == 0             ? &low[c]
                                : row == rows_       ? &high[c]
                                : column == 0        ? &left[r]
                                : column == columns_ ? &right[r]
                                                     : nullptr;
      Vec2 uv;
      if (on != nullptr) {
        uv = on->uv;
      } else {
        const double up = up_left[r] + along_low[c] * (up_right[r] - up_left[r]);
        const double along = along_low[c] + up_left[r] * (along_high[c] - along_low[c]);
        uv = (1.0 - up) * low[c].uv + up * high[c].uv + (1.0 - along) * left[r].uv +
             along * right[r].uv -
             (1.0 - up) * ((1.0 - along) * low.front().uv + along * low.back().uv) -
             up * ((1.0 - along) * high.front().uv + along * high.back().uv);
      }
      const SurfaceFrame frame = evaluator.frame(face, uv.x(), uv.y());
      data.point = {face, uv.x(), uv.y(), frame.xyz};
      data.normal = frame.normal;
      if (on == nullptr) continue;
      data.point.xyz = on->xyz;
      data.node = on->node;
      data.support = on->support;
    }
  }
}

double StripGrid::length(int column) const {
  double length = 0.0;
  for (int row = 0; row < rows_; ++row) {
    length += (at(column, row + 1).point.xyz - at(column, row).point.xyz).norm();
  }
  return length;
}

double StripGrid::width(int column) const {
  const Vec3 across = at(column, rows_).point.xyz - at(column, 0).point.xyz;
  double sine = 1.0;
  for (const int row : {0, rows_}) {
    const Vec3 along = at(std::min(column + 1, columns_), row).point.xyz -
                       at(std::max(column - 1, 0), row).point.xyz;
    sine = std::min(sine, across.cross(along).norm() / (across.norm() * along.norm()));
  }
  return length(column) * sine;
}

double StripGrid::turn_across(int column) const {
  double most = 0.0;
  for (int row = 0; row < rows_; ++row) {
    most = std::max(most, angle_between(at(column, row).normal, at(column, row + 1).normal));
  }
  return most;
}

// One vertex for each node; those of a seam, but for its ends, lie inside the patch.
std::vector<VertexH> StripGrid::add_vertices(SurfaceMesh& mesh) const {
  std::vector<VertexH> vertices;
  std::map<NodeId, VertexH> of_node;
  for (int row = 0; row <= rows_; ++row) {
    for (int column = 0; column <= columns_; ++column) {
      VertexData data = at(column, row);
      const NodeId node = data.node;
      const auto known = of_node.find(node);
      if (node.valid() && known != of_node.end()) {
        vertices.push_back(known->second);
        continue;
      }
      if (ring_) {
        const bool again = column == columns_;
        vertices.push_back(again ? vertices[index(0, row)] : mesh.add_vertex(data));
        continue;
      }
      const bool across = row > 0 && row<rows_, along = column> 0 && column < columns_;
      const bool on_seam = (across && !along && sides_[3][static_cast<std::size_t>(row)].seam) ||
                           (along && !across && sides_[0][static_cast<std::size_t>(column)].seam);
      if (on_seam) {
        data.node = NodeId();
        data.support = Support::kPatch;
      }
      vertices.push_back(mesh.add_vertex(data));
      if (node.valid()) of_node[node] = vertices.back();
    }
  }
  return vertices;
}

void StripGrid::mark_border(SurfaceMesh& mesh, const std::vector<VertexH>& vertices) const {
  const auto mark = [&](int from, int to, std::size_t a, std::size_t b, const Side& side, bool on) {
    const BoundaryPoint& begin = side[static_cast<std::size_t>(on ? from : to)];
    if (begin.seam) return;
    const HalfedgeH h = mesh.find_halfedge(vertices[a], vertices[b]);
    mesh.set_frozen(h, true);
    mesh.set_curve(h, begin.edge);
  };
  for (int c = 0; c < columns_; ++c) {
    mark(c, c + 1, index(c, 0), index(c + 1, 0), sides_[0], true);
    mark(c, c + 1, index(c, rows_), index(c + 1, rows_), sides_[2], false);
  }
  for (int r = 0; r < rows_ && !ring_; ++r) {
    mark(r, r + 1, index(columns_, r), index(columns_, r + 1), sides_[1], true);
    mark(r, r + 1, index(0, r), index(0, r + 1), sides_[3], false);
  }
}

void StripGrid::place(int column, int row, const SurfacePoint& point, const Vec3& normal) {
  VertexData& data = points_[index(column, row)];
  data.point = point;
  data.normal = normal;
}

SurfaceMesh StripGrid::mesh(std::vector<VertexH>* placed) const {
  SurfaceMesh mesh;
  const std::vector<VertexH> vertices = add_vertices(mesh);
  std::vector<std::vector<VertexH>> faces;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const VertexH a = vertices[index(column, row)], b = vertices[index(column + 1, row)],
                    c = vertices[index(column + 1, row + 1)], d = vertices[index(column, row + 1)];
      faces.push_back({a, b, c, d});
    }
  }
  mesh.build(faces);
  mark_border(mesh, vertices);
  if (placed != nullptr) *placed = vertices;
  return mesh;
}

}  // namespace advlayers
