// Loops and edges that face each other across a gap: their nodes stand opposite each other.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <algorithm>
#include <cmath>

#include "boundary/discretization.h"
#include "boundary/facing_parts.h"
#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"

namespace advlayers::test {
namespace {

// Its edge begins at this angle [rad].
TopoDS_Wire circle_from(double x, double radius, double start) {
  const gp_Dir along(std::cos(start), std::sin(start), 0);
  const gp_Circ circle(gp_Ax2(gp_Pnt(x, 0, 0), gp_Dir(0, 0, 1), along), radius);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
}

TopoDS_Face with_holes(const TopoDS_Wire& outer, const std::vector<TopoDS_Wire>& holes) {
  BRepBuilderAPI_MakeFace face(gp_Pln(), outer);
  for (const TopoDS_Wire& hole : holes) face.Add(TopoDS::Wire(hole.Reversed()));
  return face.Face();
}

Discretization cut(const Model& model, double size) {
  Settings settings = coarse_settings();
  settings.size = size;
  settings.first_height = 0.05 * size;
  Evaluator evaluator(model);
  return discretize(RunContext(), evaluator, settings);
}

// Angles of the nodes at that distance from the axis, rising [rad].
std::vector<double> angles_at(const Discretization& boundary, double radius) {
  std::vector<double> angles;
  for (const auto& node : boundary.nodes) {
    if (std::abs(std::hypot(node.xyz.x(), node.xyz.y()) - radius) > 1e-6) continue;
    angles.push_back(std::atan2(node.xyz.y(), node.xyz.x()));
  }
  std::sort(angles.begin(), angles.end());
  return angles;
}

struct Ring {
  double outer, inner, start, size;
};

class Rings : public testing::TestWithParam<Ring> {};

TEST_P(Rings, HaveTheirNodesOnCommonRays) {
  const Ring& ring = GetParam();
  const Model model =
      model_of(with_holes(circle_wire(0, 0, ring.outer), {circle_from(0, ring.inner, ring.start)}));
  const Discretization boundary = cut(model, ring.size);
  const std::vector<double> outer = angles_at(boundary, ring.outer);
  const std::vector<double> inner = angles_at(boundary, ring.inner);
  ASSERT_EQ(outer.size(), inner.size());
  ASSERT_GE(outer.size(), 18u);
  const double across = ring.outer - ring.inner;
  for (std::size_t k = 0; k < outer.size(); ++k) {
    EXPECT_LT(std::abs(outer[k] - inner[k]) * ring.inner, 0.2 * across);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, Rings,
                         testing::Values(Ring{44, 40, 0.0, 8.8}, Ring{44, 40, 2.0, 8.8},
                                         Ring{10, 9.5, 1.0, 2.0}, Ring{10, 8, -2.0, 2.0}));

TEST(FacingParts, HolesNearToEachOtherHaveMirroredNodesBetweenThem) {
  for (const double gap : {0.1, 0.3, 0.5}) {
    const double x = 15.0 + 0.5 * gap;
    const TopoDS_Wire plate = outline_wire({{-60, -40}, {60, -40}, {60, 40}, {-60, 40}});
    const Model model =
        model_of(with_holes(plate, {circle_from(-x, 15, 0.0), circle_from(x, 15, 0.0)}));
    const Discretization boundary = cut(model, 3);
    int between = 0;
    for (const auto& node : boundary.nodes) {
      const Vec3& p = node.xyz;
      if (std::abs(p.x()) > 0.5 * gap + 0.5 || std::abs(p.y()) > 3.5) continue;
      ++between;
      double nearest = 1e9;
      for (const auto& other : boundary.nodes) {
        nearest = std::min(nearest, (other.xyz - Vec3(-p.x(), p.y(), 0.0)).norm());
      }
      EXPECT_LT(nearest, 0.15) << gap;
    }
    EXPECT_GE(between, 4) << gap;
  }
}

TEST(FacingParts, ATipHasItsSidesCutAlike) {
  const Model model = model_of(polygon_face({{0, 0}, {30, -1.5}, {30, 1.5}}));
  const Discretization boundary = cut(model, 2);
  for (const auto& node : boundary.nodes) {
    if (node.xyz.x() > 25.0) continue;  // the gap is wider than some segments from there on
    double nearest = 1e9;
    for (const auto& other : boundary.nodes) {
      nearest = std::min(nearest, (other.xyz - Vec3(node.xyz.x(), -node.xyz.y(), 0.0)).norm());
    }
    EXPECT_LT(nearest, 1e-6);
  }
}

TEST(FacingParts, AWideRingIsCutEachLoopByItself) {
  const Model model = model_of(with_holes(circle_wire(0, 0, 40), {circle_from(0, 10, 1.0)}));
  const Discretization boundary = cut(model, 4);
  EXPECT_GT(angles_at(boundary, 40).size(), angles_at(boundary, 10).size());
}

}  // namespace
}  // namespace advlayers::test
