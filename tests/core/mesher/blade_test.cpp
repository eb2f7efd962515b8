// A lofted blade of one face: it is closed along its sharp trailing edge, and its leading edge is
// rounder than elements of the size can follow.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Wire.hxx>

#include <algorithm>
#include <cmath>

#include "boundary/discretization.h"
#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

constexpr int kPointsOfSide = 24;
constexpr double kSpan = 30;

// Half the thickness of a symmetric airfoil of unit chord with a closed trailing edge.
double half_thickness(double x, double thickness) {
  return 5 * thickness *
         (0.2969 * std::sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))));
}

struct Section {
  double z, chord, twist, thickness;  // [mm], [mm], [rad], of the chord
};

TopoDS_Wire section_wire(const Section& section) {
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 2 * kPointsOfSide + 1);
  const double c = std::cos(section.twist), s = std::sin(section.twist);
  for (int k = -kPointsOfSide; k <= kPointsOfSide; ++k) {
    const double x = (1 - std::cos(M_PI * k / kPointsOfSide)) / 2;
    const double half = std::abs(k) == kPointsOfSide ? 0 : half_thickness(x, section.thickness);
    const double a = section.chord * (x - 0.3), b = section.chord * (k < 0 ? half : -half);
    points->SetValue(k + kPointsOfSide + 1, gp_Pnt(a * c - b * s, a * s + b * c, section.z));
  }
  GeomAPI_Interpolate curve(points, Standard_False, 1e-7);
  curve.Perform();
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(curve.Curve()).Edge()).Wire();
}

Model blade() {
  BRepOffsetAPI_ThruSections loft(Standard_True);
  for (const Section& section : {Section{0, 10, 0.7, 0.18}, Section{10, 8, 0.44, 0.14},
                                 Section{20, 6, 0.2, 0.12}, Section{kSpan, 3, 0.09, 0.1}}) {
    loft.AddWire(section_wire(section));
  }
  return model_of(loft.Shape());
}

class Blade : public testing::TestWithParam<double> {
 protected:
  Blade() : model(blade()) {
    settings.size = GetParam();
    settings.first_height = settings.size / 15;
    settings.growth = 1.2;
  }
  const Model model;
  Settings settings = test::coarse_settings();
};

TEST_P(Blade, KeepsTheWayAroundItsLeadingEdgeClear) {
  const MeshResult mesh = mesh_of(model, settings);
  expect_watertight(mesh);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GE(mesh.figures.quad_percent, 98.0);
  EXPECT_GE(mesh.figures.angles_45_135_percent, 96.0);
}

// The seam's two sides have different normals at its ends, and neither is a fold of the surface.
TEST_P(Blade, IsCutNoFinerAtItsTrailingEdgeThanItIsCurved) {
  Evaluator evaluator(model);
  const Discretization cut = discretize(RunContext(), evaluator, settings);
  double shortest = kSpan;
  for (const EdgeNodes& edge : cut.edges) {
    for (std::size_t k = 1; k < edge.nodes.size(); ++k) {
      const Vec3 a = cut.nodes[edge.nodes[k - 1].index()].xyz;
      const Vec3 b = cut.nodes[edge.nodes[k].index()].xyz;
      shortest = std::min(shortest, (b - a).norm());
    }
  }
  const double radius = 1.1019 * 0.1 * 0.1 * 3;  // of the leading edge at the tip
  EXPECT_GT(shortest, radius * settings.curvature_angle * M_PI / 180 / 4);
}

INSTANTIATE_TEST_SUITE_P(Sizes, Blade, testing::Values(0.8, 0.32));

}  // namespace
}  // namespace advlayers::test
