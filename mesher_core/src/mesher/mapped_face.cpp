#include "mesher/mapped_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boundary/divide_length.h"
#include "geometry/face_corners.h"
#include "measure/element_measures.h"
#include "mesher/narrow_strip.h"
#include "triangulate/strip_grid.h"
#include "triangulate/target_size.h"

namespace advlayers {
namespace {

constexpr double kLeastAngle = 10.0, kLargestAngle = 170.0;  // [deg] of an element
// Likewise where nobody asked, and the lengths of mesh edges over the size there.
constexpr double kLeastFitting = 50.0, kLargestFitting = 130.0;
constexpr double kShortestFitting = 0.5, kLongestFitting = 1.25;
// A segment beside a wall is a layer of it where it has its height, or less in a gap that closes.
constexpr double kLeastOfLayer = 0.6, kMostOfLayer = 1.1;

// The plan that all edges of a side share, if they are a wall.
const EdgePlan* wall_along(const std::vector<CoEdge>& side, const WallPlan& walls) {
  const EdgePlan* found = nullptr;
  for (const CoEdge& coedge : side) {
    const auto plan = walls.edges.find(coedge.edge);
    if (plan == walls.edges.end() || plan->second.condition != EdgeCondition::kWall) return nullptr;
    found = &plan->second;
  }
  return found;
}

// One side of a grid with what lies beside it: row 0 along the side, the further ones inwards.
class GridSide {
 public:
  GridSide(const StripGrid& grid, int side) : grid_(&grid), side_(side) {}

  bool along_rows() const { return side_ % 2 == 0; }                             // of the grid
  int along() const { return along_rows() ? grid_->columns() : grid_->rows(); }  // segments
  int inward() const { return along_rows() ? grid_->rows() : grid_->columns(); }
  // The grid's column and row of a place.
  std::pair<int, int> place(int along, int inward) const {
    switch (side_) {
      case 0:
        return {along, inward};
      case 1:
        return {grid_->columns() - inward, along};
      case 2:
        return {along, grid_->rows() - inward};
      default:
        return {inward, along};
    }
  }
  const VertexData& at(int along, int inward) const {
    const auto [column, row] = place(along, inward);
    return grid_->at(column, row);
  }
  double step(int along, int inward) const {  // [mm] from one row to the next
    return (at(along, inward + 1).point.xyz - at(along, inward).point.xyz).norm();
  }
  // The sine of the angle between the side and the column that leaves it.
  double sine(int along) const {
    const Vec3 up = at(along, 1).point.xyz - at(along, 0).point.xyz;
    const Vec3 on = at(std::min(along + 1, this->along()), 0).point.xyz -
                    at(std::max(along - 1, 0), 0).point.xyz;
    return up.cross(on).norm() / (up.norm() * on.norm());
  }

 private:
  const StripGrid* grid_;
  int side_;
};

// How many layers of a wall each column has, and how high they are to be.
class WallSide {
 public:
  WallSide(const StripGrid& grid, int side, const EdgePlan* plan, bool isotropic)
      : side_(grid, side), plan_(plan) {
    if (plan_ == nullptr) return;
    asked_ = plan_->growth.layers_left;
    layers_ = std::min(
        {asked_, side_.inward(), layers_at(0, isotropic), layers_at(side_.along(), isotropic)});
  }

  int layers() const { return layers_; }
  void hold_to(int most) { layers_ = std::min(layers_, most); }
  bool complete() const { return plan_ != nullptr && layers_ == asked_; }
  const GridSide& side() const { return side_; }
  // From the wall to the top of its layers on that column, along it [mm].
  std::vector<double> heights(int along) const {
    std::vector<double> tops{0.0};
    if (layers_ == 0) return tops;
    const double sine = std::max(0.1, side_.sine(along));
    Growth growth = plan_->growth_at(side_.at(along, 0).node);
    for (int k = 0; k < layers_; ++k, growth = growth.next()) {
      tops.push_back(tops.back() + growth.height / sine);
    }
    return tops;
  }

 private:
  int layers_at(int along, bool isotropic) const {
    const double sine = side_.sine(along);
    const double segment =
        (side_.at(along == 0 ? 1 : along - 1, 0).point.xyz - side_.at(along, 0).point.xyz).norm();
    Growth growth = plan_->growth_at(side_.at(along, 0).node);
    int found = 0;
    while (found < side_.inward() && growth.layers_left > 0) {
      const double part = side_.step(along, found) * sine / growth.height;
      const bool open = plan_->growth.layers_left == kUntilClosed;
      if (isotropic && open && growth.height >= segment) break;
      if (part < kLeastOfLayer || part > kMostOfLayer) break;
      growth = growth.next();
      ++found;
    }
    return found;
  }

  GridSide side_;
  const EdgePlan* plan_;
  int asked_ = 0;
  int layers_ = 0;
};

// Shares of the way across a ring: the layers of its walls, and rows of the size between them.
class RingRows {
 public:
  RingRows(const FourSides& sides, const WallPlan& walls, double size)
      : low_(wall_along(sides.sides[0], walls)),
        high_(wall_along(sides.sides[2], walls)),
        walls_(walls),
        size_(size),
        edge_(sides.sides[0].front().edge) {}

  std::vector<double> operator()(const StripGrid::Side& rim, double width) const {
    double around = 0.0;
    for (std::size_t k = 1; k < rim.size(); ++k) around += (rim[k].xyz - rim[k - 1].xyz).norm();
    const double segment = around / static_cast<double>(rim.size() - 1);
    const LayeredCuts cuts = lay_out_layers(width, series(low_, segment), series(high_, segment));
    std::vector<double> at{0.0}, from_end{width};
    for (const double step : cuts.segments[0]) at.push_back(at.back() + step);
    for (const double step : cuts.segments[1]) from_end.push_back(from_end.back() - step);
    const double begin = at.back(), end = from_end.back();
    if (!cuts.closed && end > begin) {
      for (const double cut : divide_by_spacing(between(cuts, begin, end), 1, edge_)) {
        if (cut > begin && cut < end) at.push_back(cut);
      }
    }
    at.insert(at.end(), from_end.rbegin(), from_end.rend());
    for (double& place : at) place /= width;
    return at;
  }

 private:
  std::vector<LayerSeries> series(const EdgePlan* plan, double segment) const {
    if (plan == nullptr) return {};
    LayerSeries layers;
    layers.height = plan->growth.height;
    layers.growth = plan->growth.ratio;
    layers.layers = plan->growth.layers_left;
    layers.most = walls_.max_height;
    if (walls_.stop_at_isotropy) layers.isotropic = segment;
    return {layers};
  }
  // The size, held to what the last layers are high, and growing away from them.
  std::vector<SpacingSample> between(const LayeredCuts& cuts, double begin, double end) const {
    std::vector<SpacingSample> samples;
    for (int k = 0; k <= kSamples; ++k) {
      const double s = begin + (end - begin) * k / kSamples;
      double spacing = size_;
      const double beyond[2] = {s - begin, end - s};
      for (const std::size_t e : {0, 1}) {
        if (cuts.segments[e].empty()) continue;
        spacing = std::min(spacing, cuts.segments[e].back() + kSlope * beyond[e]);
      }
      samples.push_back({s, spacing});
    }
    return samples;
  }

  static constexpr int kSamples = 32;    // of the spacing across: it is linear between them
  static constexpr double kSlope = 0.3;  // rows grow so much over their length

  const EdgePlan *low_, *high_;
  const WallPlan& walls_;
  double size_;
  EdgeId edge_;
};

class FaceMapper {
 public:
  FaceMapper(const RunContext& context, Evaluator& evaluator, StripGrid grid,
             const FourSides& sides, const WallPlan& walls)
      : context_(context), evaluator_(evaluator), face_(sides.face), grid_(std::move(grid)) {
    for (int k = 0; k < 4; ++k) {
      walls_.emplace_back(grid_, k, wall_along(sides.sides[static_cast<std::size_t>(k)], walls),
                          walls.stop_at_isotropy);
    }
    // Layers of facing walls share the rows between them.
    for (const int k : {0, 1}) {
      WallSide &a = wall(k), &b = wall(k + 2);
      const int rows = a.side().inward();
      if (a.layers() + b.layers() <= rows) continue;
      a.hold_to(std::max(rows / 2, rows - b.layers()));
      b.hold_to(rows - a.layers());
    }
    isotropic_ = walls.stop_at_isotropy;
  }

  MappedMesh run() {
    lift();
    for (const int k : {0, 1}) hold_heights(wall(k), wall(k + 2));
    MappedMesh made;
    std::vector<VertexH> vertices;
    made.mesh = grid_.mesh(&vertices);
    mark_layers(made, vertices);
    return made;
  }

 private:
  WallSide& wall(int k) { return walls_[static_cast<std::size_t>(k)]; }

  // Between the sides in space, and down on the face; where that makes no better elements than
  // between them in (u, v), it stays at those.
  void lift() {
    if (evaluator_.model().face(face_).kind == SurfaceKind::kPlane) return;
    StripGrid lifted = grid_;
    for (int row = 1; row < grid_.rows(); ++row) {
      context_.check();
      for (int column = 1; column < grid_.columns(); ++column) {
        const SurfacePoint seed = grid_.at(column, row).point;
        SurfacePoint foot;
        if (!evaluator_.project(between_sides(column, row), seed, foot)) return;
        lifted.place(column, row, foot, evaluator_.normal(foot));
      }
    }
    if (least_quality(lifted) > least_quality(grid_)) grid_ = std::move(lifted);
  }

  Vec3 between_sides(int column, int row) const {
    const auto p = [this](int c, int r) -> const Vec3& { return grid_.at(c, r).point.xyz; };
    const int n = grid_.columns(), m = grid_.rows();
    const auto share = [](const Vec3& from, const Vec3& at, const Vec3& to) {
      const double before = (at - from).norm(), after = (to - at).norm();
      return before / (before + after);
    };
    const double a = share(p(0, 0), p(column, 0), p(n, 0));
    const double b = share(p(0, m), p(column, m), p(n, m));
    const double c = share(p(0, 0), p(0, row), p(0, m));
    const double d = share(p(n, 0), p(n, row), p(n, m));
    const double v = (c + a * (d - c)) / (1.0 - (b - a) * (d - c));
    const double u = a + v * (b - a);
    return (1.0 - v) * p(column, 0) + v * p(column, m) + (1.0 - u) * p(0, row) + u * p(n, row) -
           (1.0 - v) * ((1.0 - u) * p(0, 0) + u * p(n, 0)) -
           v * ((1.0 - u) * p(0, m) + u * p(n, m));
  }

  double least_quality(const StripGrid& grid) const {
    double least = 1.0;
    for (int row = 0; row < grid.rows(); ++row) {
      for (int column = 0; column < grid.columns(); ++column) {
        const VertexData& corner = grid.at(column, row);
        least = std::min(least,
                         right_angle_quality(corner.point.xyz, grid.at(column + 1, row).point.xyz,
                                             grid.at(column + 1, row + 1).point.xyz,
                                             grid.at(column, row + 1).point.xyz, corner.normal));
      }
    }
    return least;
  }

  // Moves the points of each column along it, so that the layers from either end have the heights
  // asked for, and what lies between shares the rest as before.
  void hold_heights(const WallSide& from, const WallSide& to) {
    if (from.layers() + to.layers() == 0) return;
    const int last = from.side().along();
    for (int along = grid_.ring() ? 0 : 1; along < last; ++along) hold_column(from, to, along);
    for (int row = 1; grid_.ring() && row < grid_.rows(); ++row) {
      const VertexData& first = grid_.at(0, row);
      grid_.place(last, row, first.point, first.normal);
    }
  }

  void hold_column(const WallSide& from, const WallSide& to, int along) {
    context_.check();
    const GridSide& side = from.side();
    const int n = side.inward();
    std::vector<double> walked{0.0};
    for (int k = 0; k < n; ++k) walked.push_back(walked.back() + side.step(along, k));
    const std::vector<double> low = from.heights(along), high = to.heights(along);
    const double length = walked.back();
    const int first = from.layers(), last = n - to.layers();
    // Rows that close a gap share it as they lie.
    if (first >= last || low.back() + high.back() >= length) return;
    const double begin = walked[static_cast<std::size_t>(first)],
                 end = walked[static_cast<std::size_t>(last)];
    std::vector<SurfacePoint> moved;
    for (int k = 1; k < n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const double part = (walked[i] - begin) / (end - begin);
      const double at = k <= first  ? low[i]
                        : k >= last ? length - high[static_cast<std::size_t>(n - k)]
                                    : low.back() + part * (length - high.back() - low.back());
      moved.push_back(point_along(side, along, walked, at));
    }
    for (int k = 1; k < n; ++k) {
      const SurfacePoint& point = moved[static_cast<std::size_t>(k - 1)];
      const auto [column, row] = side.place(along, k);
      grid_.place(column, row, point, evaluator_.normal(point));
    }
  }

  SurfacePoint point_along(const GridSide& side, int along, const std::vector<double>& walked,
                           double at) {
    const auto above = std::upper_bound(walked.begin() + 1, walked.end() - 1, at);
    const int k = static_cast<int>(above - walked.begin());
    const SurfacePoint &a = side.at(along, k - 1).point, &b = side.at(along, k).point;
    const double part = (at - *(above - 1)) / (*above - *(above - 1));
    const double u = a.u + part * (b.u - a.u), v = a.v + part * (b.v - a.v);
    return {face_, u, v, evaluator_.frame(face_, u, v).xyz};
  }

  // A place belongs to the nearest wall, by rows; a quad to that of its outer corner.
  void mark_layers(MappedMesh& made, const std::vector<VertexH>& vertices) {
    for (int row = 0; row <= grid_.rows(); ++row) {
      for (int column = 0; column <= grid_.columns(); ++column) {
        mark_vertex(made, vertices, column, row);
      }
    }
    for (std::size_t f = 0; f < made.mesh.face_capacity(); ++f) {
      const int row = static_cast<int>(f) / grid_.columns();
      const int column = static_cast<int>(f) % grid_.columns();
      int layer = 0;
      for (int k = 0; k < 4; ++k) {
        const int depth = depth_of(k, column, row, true) + 1;
        if (depth <= wall(k).layers() && (layer == 0 || depth < layer)) layer = depth;
      }
      made.mesh.data(FaceH(f)).layer = layer;
    }
    for (int k = 0; k < 4; ++k) made.layers = std::max(made.layers, wall(k).layers());
    for (int k = 0; k < 4; ++k) note_stops(made, vertices, k);
  }

  // Rows from side k: of a point, or of a quad, by its column and row.
  int depth_of(int k, int column, int row, bool quad) const {
    const int less = quad ? 1 : 0;
    switch (k) {
      case 0:
        return row;
      case 1:
        return grid_.columns() - less - column;
      case 2:
        return grid_.rows() - less - row;
      default:
        return column;
    }
  }

  void mark_vertex(MappedMesh& made, const std::vector<VertexH>& vertices, int column, int row) {
    VertexData& data = made.mesh.data(vertices[grid_.index(column, row)]);
    int layer = -1, nearest = 0;
    for (int k = 0; k < 4; ++k) {
      const int depth = depth_of(k, column, row, false);
      if (depth > wall(k).layers() || wall(k).layers() == 0) continue;
      if (layer < 0 || depth < layer) {
        layer = depth;
        nearest = k;
      }
    }
    if (layer <= 0) return;
    data.layer = layer;
    const int c = column + (nearest == 1 ? 1 : nearest == 3 ? -1 : 0);
    const int r = row + (nearest == 0 ? -1 : nearest == 2 ? 1 : 0);
    data.parent = vertices[grid_.index(c, r)];
  }

  void note_stops(MappedMesh& made, const std::vector<VertexH>& vertices, int k) {
    const WallSide& here = wall(k);
    if (here.layers() == 0) return;
    const bool met = here.layers() + wall((k + 2) % 4).layers() >= here.side().inward() - 1;
    const Stop reason = here.complete() ? Stop::kLayersReached
                        : met           ? Stop::kClosed
                        : isotropic_    ? Stop::kIsotropic
                                        : Stop::kClosed;
    // Beside a wall that meets this one, columns run into its layers; a place as near to both
    // belongs to the side of the lower number.
    const int begin = k % 2 == 0 ? 3 : 0, end = k % 2 == 0 ? 1 : 2;
    const int last = here.side().along();
    for (int along = 0; along <= last; ++along) {
      int own = here.layers();
      for (const auto& [other, steps] : {std::pair(begin, along), std::pair(end, last - along)}) {
        if (wall(other).layers() == 0 || steps > wall(other).layers()) continue;
        own = std::min(own, other < k ? std::max(0, steps - 1) : steps);
      }
      const auto [column, row] = here.side().place(along, 0);
      made.stops.push_back({vertices[grid_.index(column, row)],
                            own < here.layers() ? Stop::kMerged : reason, own + 1});
    }
  }

  const RunContext& context_;
  Evaluator& evaluator_;
  FaceId face_;
  StripGrid grid_;
  std::vector<WallSide> walls_;
  bool isotropic_ = false;
};

}  // namespace

std::optional<FourSides> find_mapped_sides(Evaluator& evaluator, FaceId id) {
  std::optional<FourSides> found = find_four_sides(evaluator, id);
  const Face& face = evaluator.model().face(id);
  if (found || face.kind != SurfaceKind::kPlane || face.loops.size() != 2) return found;
  found.emplace();
  found->face = id;
  found->lengths.fill(0.0);
  for (const std::size_t k : {0, 1}) {
    found->sides[2 * k] = face.loops[k];
    for (const CoEdge& coedge : face.loops[k]) {
      if (coedge.degenerate || coedge.seam) return std::nullopt;
      found->lengths[2 * k] += evaluator.model().edge(coedge.edge).length;
    }
  }
  return found;
}

std::vector<MatchEnd> ends_of_mapped(Evaluator& evaluator, const FourSides& sides,
                                     const WallPlan& walls) {
  std::vector<MatchEnd> ends;
  const auto add = [&](const EdgePlan* plan, const FaceCorner& corner, CornerSide wall,
                       CornerSide along) {
    if (plan == nullptr) return;
    MatchEnd end;
    end.edge = along.edge;
    end.end = along.end;
    end.wall = wall.edge;
    end.wall_end = wall.end;
    end.face = sides.face;
    end.spacing = {plan->growth.height, plan->growth.ratio, plan->growth.layers_left, plan->rule};
    end.sine = std::sin(corner.angle);
    end.stop_at_isotropy = walls.stop_at_isotropy;
    end.max_height = walls.max_height;
    ends.push_back(end);
  };
  for (std::size_t k = 0; k < 4 && !sides.sides[1].empty(); ++k) {
    const std::vector<CoEdge>&side = sides.sides[k], &next = sides.sides[(k + 1) % 4];
    const FaceCorner corner = corner_between(evaluator, sides.face, side.back(), next.front());
    add(wall_along(side, walls), corner, corner.in, corner.out);
    add(wall_along(next, walls), corner, corner.out, corner.in);
  }
  return ends;
}

std::optional<MappedMesh> mesh_mapped(const RunContext& context, Evaluator& evaluator,
                                      PatchSurface& surface, const Discretization& boundary,
                                      const FourSides& sides, const WallPlan& walls, double size) {
  const bool ring = sides.sides[1].empty();
  std::optional<StripGrid> grid = ring
                                      ? StripGrid::lay_out_ring(context, evaluator, boundary, sides,
                                                                RingRows(sides, walls, size))
                                      : StripGrid::lay_out(context, evaluator, boundary, sides);
  if (!grid) return std::nullopt;
  MappedMesh made = FaceMapper(context, evaluator, std::move(*grid), sides, walls).run();
  if (!angles_within(context, made.mesh, surface, kLeastAngle, kLargestAngle)) return std::nullopt;
  return made;
}

bool fits(const RunContext& context, Evaluator& evaluator, PatchSurface& surface,
          const SurfaceMesh& mesh, const Settings& settings) {
  if (!angles_within(context, mesh, surface, kLeastFitting, kLargestFitting)) return false;
  TargetSize target(evaluator, settings);
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
    const HalfedgeH h(i);
    if (!mesh.alive(h)) continue;
    const VertexData &a = mesh.data(mesh.from(h)), &b = mesh.data(mesh.to(h));
    const double size = std::min(target.at(a.point), target.at(b.point));
    const double length = (a.point.xyz - b.point.xyz).norm();
    if (length < kShortestFitting * size || length > kLongestFitting * size) return false;
  }
  return true;
}

}  // namespace advlayers
