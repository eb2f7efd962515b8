#include "geometry/facet_shape.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRep_Builder.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <map>
#include <set>
#include <tuple>

#include "geometry/occt_shape.h"

namespace advlayers {
namespace {

using Corners = std::array<int, 3>;

constexpr double kSamePoint = 1e-6;    // of the diagonal
constexpr double kLeastLength = 2e-7;  // [mm] OpenCASCADE makes no edge of less than half of it

// Gives points their numbers; those in one place share one. A grid of cells as wide as the
// tolerance: what is within it lies in the same cell or next to it.
class Places {
 public:
  explicit Places(double tolerance) : tolerance_(tolerance) {}

  int number_of(const Vec3& p) {
    const Cell cell = cell_of(p);
    const auto [x, y, z] = cell;
    for (const double i : {x, x - 1, x + 1}) {
      for (const double j : {y, y - 1, y + 1}) {
        for (const double k : {z, z - 1, z + 1}) {
          const auto found = numbers_.find({i, j, k});
          if (found == numbers_.end()) continue;
          const Vec3& there = points_[static_cast<std::size_t>(found->second)];
          if ((there - p).norm() <= tolerance_) return found->second;
        }
      }
    }
    const int number = static_cast<int>(points_.size());
    points_.push_back(p);
    numbers_.emplace(cell, number);
    return number;
  }

  const std::vector<Vec3>& points() const { return points_; }

 private:
  using Cell = std::tuple<double, double, double>;
  Cell cell_of(const Vec3& p) const {
    return {std::round(p.x() / tolerance_), std::round(p.y() / tolerance_),
            std::round(p.z() / tolerance_)};
  }

  double tolerance_;
  std::vector<Vec3> points_;
  std::map<Cell, int> numbers_;
};

double diagonal_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  Eigen::AlignedBox3d box;
  for (const auto& triangle : triangles) {
    for (const Vec3& corner : triangle) box.extend(corner);
  }
  return box.diagonal().norm();
}

class Shell {
 public:
  explicit Shell(const std::vector<Vec3>& points) : points_(points) {
    builder_.MakeShell(shell_);
    for (const Vec3& p : points) vertices_.push_back(BRepBuilderAPI_MakeVertex(to_pnt(p)).Vertex());
  }

  void add(const Corners& corners) {
    const auto [a, b, c] = corners;
    const Vec3 normal = (point(b) - point(a)).cross(point(c) - point(a));
    if (!(normal.norm() > 0.0)) return;
    TopoDS_Wire wire;
    builder_.MakeWire(wire);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      builder_.Add(wire, edge(from, to));
    }
    wire.Closed(Standard_True);
    const gp_Pln plane(to_pnt(point(a)), gp_Dir(normal.x(), normal.y(), normal.z()));
    builder_.Add(shell_, BRepBuilderAPI_MakeFace(plane, wire, Standard_True).Face());
    ++faces_;
  }

  TopoDS_Shape shape() const { return faces_ > 0 ? TopoDS_Shape(shell_) : TopoDS_Shape(); }

 private:
  const Vec3& point(int i) const { return points_[static_cast<std::size_t>(i)]; }

  // Shared by the two faces at it, which run along it in turned directions.
  TopoDS_Edge edge(int from, int to) {
    const std::pair<int, int> ends(std::min(from, to), std::max(from, to));
    auto found = edges_.find(ends);
    if (found == edges_.end()) {
      const TopoDS_Vertex &first = vertices_[static_cast<std::size_t>(ends.first)],
                          &second = vertices_[static_cast<std::size_t>(ends.second)];
      found = edges_.emplace(ends, BRepBuilderAPI_MakeEdge(first, second).Edge()).first;
    }
    return from < to ? found->second : TopoDS::Edge(found->second.Reversed());
  }

  const std::vector<Vec3>& points_;
  BRep_Builder builder_;
  TopoDS_Shell shell_;
  std::vector<TopoDS_Vertex> vertices_;
  std::map<std::pair<int, int>, TopoDS_Edge> edges_;
  int faces_ = 0;
};

}  // namespace

TopoDS_Shape shape_of_triangles(const std::vector<std::array<Vec3, 3>>& triangles) {
  Places places(std::max(kSamePoint * diagonal_of(triangles), kLeastLength));
  std::vector<Corners> kept;
  std::set<Corners> seen;
  for (const auto& triangle : triangles) {
    Corners corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = places.number_of(triangle[i]);
    Corners sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const bool flat = sorted[0] == sorted[1] || sorted[1] == sorted[2];
    if (!flat && seen.insert(sorted).second) kept.push_back(corners);
  }
  Shell shell(places.points());
  for (const Corners& corners : kept) shell.add(corners);
  return shell.shape();
}

}  // namespace advlayers
