#include "mesher/narrow_strip.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "measure/element_measures.h"
#include "mend/inversion.h"
#include "sizing/gap_rule.h"
#include "sizing/size_field.h"
#include "triangulate/strip_grid.h"

namespace advlayers {
namespace {

constexpr double kLeastAngle = 20.0, kLargestAngle = 160.0;  // [deg] of an element
constexpr double kNarrow = 2.0;                              // at most so many sizes
constexpr double kWidest = 1.1;                              // step across, of the size
// A step across may turn with the surface by this much, or this many times more than at the ends.
constexpr double kMostTurn = 35.0 * kDegree;
constexpr double kTurnOfEnds = 1.25;

class StripWalls {
 public:
  StripWalls(const FourSides& strip, const WallPlan& walls) : strip_(strip), walls_(walls) {}

  // Whether the patch ends where the face does, but for a seam.
  bool bound_patch() const {
    for (const auto& side : strip_.sides) {
      for (const CoEdge& coedge : side) {
        if (coedge.seam == (walls_.edges.count(coedge.edge) > 0)) return false;
      }
    }
    return true;
  }

  // Whether layers run along the strip or from one side of it alone.
  bool are_mixed() const {
    const bool none = std::none_of(walls_.edges.begin(), walls_.edges.end(), [](const auto& entry) {
      return entry.second.condition == EdgeCondition::kWall;
    });
    return !none && !(is_wall(strip_.sides[0]) && is_wall(strip_.sides[2]));
  }

  // Whether a layer fits on both sides of a gap [mm], by the least first heights asked for there.
  bool leave_room(double gap, NodeId low = NodeId(), NodeId high = NodeId()) const {
    return height_in_gap(height_at(strip_.sides[0], low), gap) > 0.0 ||
           height_in_gap(height_at(strip_.sides[2], high), gap) > 0.0;
  }

 private:
  bool is_wall(const std::vector<CoEdge>& side) const {
    return std::all_of(side.begin(), side.end(), [this](const CoEdge& coedge) {
      const auto plan = walls_.edges.find(coedge.edge);
      return plan != walls_.edges.end() && plan->second.condition == EdgeCondition::kWall;
    });
  }
  double height_at(const std::vector<CoEdge>& side, NodeId node) const {
    double height = std::numeric_limits<double>::infinity();
    for (const CoEdge& coedge : side) {
      const auto plan = walls_.edges.find(coedge.edge);
      if (plan == walls_.edges.end() || plan->second.condition != EdgeCondition::kWall) continue;
      height = std::min(height, plan->second.height_at(node));
    }
    return height;
  }

  const FourSides& strip_;
  const WallPlan& walls_;
};

bool has_room(const StripGrid& grid, const StripWalls& walls) {
  for (int column = 0; column <= grid.columns(); ++column) {
    if (walls.leave_room(grid.width(column), grid.at(column, 0).node,
                         grid.at(column, grid.rows()).node)) {
      return true;
    }
  }
  return false;
}

bool is_too_wide(const StripGrid& grid, double size) {
  const double most = size * std::min(kNarrow, kWidest * grid.rows());
  for (int column = 0; column <= grid.columns(); ++column) {
    if (grid.length(column) > most) return true;
  }
  return false;
}

bool turns_too_much(const StripGrid& grid) {
  const double at_ends = std::max(grid.turn_across(0), grid.turn_across(grid.columns()));
  for (int column = 1; column < grid.columns(); ++column) {
    if (grid.turn_across(column) > std::max(kMostTurn, kTurnOfEnds * at_ends)) return true;
  }
  return false;
}

}  // namespace

bool angles_within(const RunContext& context, const SurfaceMesh& mesh, PatchSurface& surface,
                   double least, double largest) {
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    context.check();
    const ElementCorners element = corners_of(mesh, FaceH(i));
    const auto angles = interior_angles(element);
    for (int k = 0; k < element.count; ++k) {
      const double angle = angles[static_cast<std::size_t>(k)];
      if (!(angle > least && angle < largest)) return false;
    }
    if (is_steep(mesh, FaceH(i), surface)) return false;
  }
  return true;
}

std::optional<FourSides> find_narrow_strip(const RunContext& context, Evaluator& evaluator,
                                           const std::vector<FaceId>& faces, const WallPlan& walls,
                                           const Settings& settings) {
  context.check();
  if (faces.size() != 1 || settings.initial_nodes != nullptr ||
      settings.core != CoreElements::kQuads) {
    return std::nullopt;
  }
  std::optional<FourSides> strip = find_four_sides(evaluator, faces.front());
  if (!strip) return std::nullopt;
  const StripWalls planned(*strip, walls);
  const double width = strip->width(evaluator.model());
  if (width > kNarrow * SizeField(settings).of_face(faces.front()) || !planned.bound_patch() ||
      planned.are_mixed() || planned.leave_room(width)) {
    return std::nullopt;
  }
  return strip;
}

std::optional<SurfaceMesh> mesh_in_rows(const RunContext& context, Evaluator& evaluator,
                                        PatchSurface& surface, const Discretization& boundary,
                                        const FourSides& strip, const WallPlan& walls,
                                        const Settings& settings) {
  const std::optional<StripGrid> grid = StripGrid::lay_out(context, evaluator, boundary, strip);
  if (!grid || has_room(*grid, StripWalls(strip, walls)) ||
      is_too_wide(*grid, SizeField(settings).of_face(strip.face)) || turns_too_much(*grid)) {
    return std::nullopt;
  }
  SurfaceMesh mesh = grid->mesh();
  if (!angles_within(context, mesh, surface, kLeastAngle, kLargestAngle)) return std::nullopt;
  return mesh;
}

}  // namespace advlayers
