// Flow domains: airfoils far inside a circle, sharp and blunt, several of them, and layers so flat
// that doubles have to be handled with care; and rings about many holes.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_HArray1OfPnt.hxx>

#include <algorithm>
#include <cmath>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

constexpr double kFarField = 50.0;  // chords

// A symmetric NACA airfoil of four digits, chord 1, clockwise; a blunt one ends in a straight edge.
TopoDS_Wire airfoil(double thickness, bool blunt) {
  const int n = 50;
  const auto height = [&](double x) {
    return 5 * thickness *
           (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x + 0.2843 * x * x * x -
            (blunt ? 0.1015 : 0.1036) * x * x * x * x);
  };
  const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, 2 * n + 1);
  for (int i = -n; i <= n; ++i) {
    const double x = 0.5 * (1 + std::cos(M_PI * (n - std::abs(i)) / n));
    const double y = !blunt && std::abs(i) == n ? 0.0 : height(x);
    points->SetValue(i + n + 1, gp_Pnt(x, i < 0 ? -y : y, 0));
  }
  GeomAPI_Interpolate spline(points, false, 1e-9);
  spline.Perform();
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(spline.Curve()).Edge());
  if (blunt) {
    wire.Add(BRepBuilderAPI_MakeEdge(points->Value(2 * n + 1), points->Value(1)).Edge());
  }
  return wire.Wire();
}

TopoDS_Wire placed(const TopoDS_Wire& wire, double scale, double degrees, double x, double y) {
  gp_Trsf size, turn, shift;
  size.SetScale(gp_Pnt(0, 0, 0), scale);
  turn.SetRotation(gp::OZ(), degrees * M_PI / 180);
  shift.SetTranslation(gp_Vec(x, y, 0));
  return TopoDS::Wire(BRepBuilderAPI_Transform(wire, shift * turn * size, true).Shape());
}

// The plane within the far field and outside the airfoils.
Model domain(const std::vector<TopoDS_Wire>& airfoils) {
  BRepBuilderAPI_MakeFace face(gp_Pln(), circle_wire(0.5, 0, kFarField));
  for (const TopoDS_Wire& wire : airfoils) face.Add(wire);
  return model_of(face.Face());
}

// Layers on the airfoils alone.
Settings flow(const Model& model, double first_height, double growth) {
  Settings settings = test::coarse_settings();
  settings.size = 5.0;
  settings.size_growth = 1.25;
  settings.curvature_angle = 10.0;
  settings.first_height = first_height;
  settings.growth = growth;
  settings.walls_all = false;
  settings.walls.resize(1);
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].length < kFarField) settings.walls[0].edges.emplace_back(e);
  }
  settings.sizes.resize(1);
  settings.sizes[0].edges = settings.walls[0].edges;
  settings.sizes[0].size = 0.02;
  return settings;
}

int layered_triangles(const MeshResult& mesh) {
  return static_cast<int>(std::count_if(mesh.triangle_layer.begin(), mesh.triangle_layer.end(),
                                        [](int layer) { return layer > 0; }));
}

void expect_complete(const MeshResult& mesh, int layers) {
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_EQ(layered_triangles(mesh), 0);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_EQ(wall.layers, layers) << edge_name(wall.edge);
    EXPECT_LT(wall.height_error, 0.02) << edge_name(wall.edge);
    EXPECT_NEAR(wall.achieved_growth, wall.growth, 0.02 * wall.growth);
  }
}

struct Airfoil {
  const char* name;
  double thickness;
  bool blunt;
};

class AirfoilDomain : public testing::TestWithParam<Airfoil> {
 protected:
  AirfoilDomain() : model(domain({airfoil(GetParam().thickness, GetParam().blunt)})) {}
  Model model;
};

TEST_P(AirfoilDomain, HasEveryLayerOnTheAirfoilAlone) {
  Settings settings = flow(model, 1e-5, 1.2);
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 25;
  const MeshResult mesh = mesh_of(model, settings);
  expect_complete(mesh, 25);
  EXPECT_EQ(mesh.walls.size(), GetParam().blunt ? 2u : 1u);
}

TEST_P(AirfoilDomain, EndsInAGradedCoreWhereLayersAreIsotropic) {
  Settings settings = flow(model, 1e-5, 1.2);
  settings.end = EndOfGrowth::kIsotropic;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.layer_quad_percent, 99.5);
  // The last layers are as high as the wall's segments are long.
  for (const WallReport& wall : mesh.walls) {
    EXPECT_GE(1e-5 * std::pow(1.2, wall.layers), 0.01) << wall.layers;
  }
  // Elements grow smoothly towards the far field: no edge is much longer than those it meets.
  std::vector<double> longest(mesh.nodes.size(), 0.0), shortest(mesh.nodes.size(), 1e9);
  for (const auto& [edge, uses] : uses_of_edges(mesh)) {
    const auto a = static_cast<std::size_t>(edge.first), b = static_cast<std::size_t>(edge.second);
    if (mesh.node_layer[a] > 0 || mesh.node_layer[b] > 0 || uses != 2) continue;
    const double length = (mesh.nodes[a] - mesh.nodes[b]).norm();
    for (const std::size_t v : {a, b}) {
      longest[v] = std::max(longest[v], length);
      shortest[v] = std::min(shortest[v], length);
    }
  }
  int uneven = 0, counted = 0;
  for (std::size_t v = 0; v < longest.size(); ++v) {
    if (longest[v] == 0.0) continue;
    ++counted;
    uneven += longest[v] > 3.5 * shortest[v];
  }
  EXPECT_LT(uneven, 0.01 * counted);
}

// Aspect ratios up to two millions.
TEST_P(AirfoilDomain, BearsExtremeAnisotropy) {
  for (const double height : {1e-6, 1e-7, 1e-8}) {
    Settings settings = flow(model, height, 1.35);
    settings.end = EndOfGrowth::kLayers;
    settings.layers = 20;
    expect_complete(mesh_of(model, settings), 20);
  }
}

INSTANTIATE_TEST_SUITE_P(Naca, AirfoilDomain,
                         testing::Values(Airfoil{"0012sharp", 0.12, false},
                                         Airfoil{"0012blunt", 0.12, true},
                                         Airfoil{"0018sharp", 0.18, false},
                                         Airfoil{"0018blunt", 0.18, true}),
                         [](const auto& foil) { return std::string(foil.param.name); });

Model three_elements() {
  const TopoDS_Wire wire = airfoil(0.12, true);
  return domain(
      {wire, placed(wire, 0.25, 25, -0.24, -0.09), placed(wire, 0.3, -30, 1.015, -0.035)});
}

TEST(HighLift, ThreeElementsHaveEveryLayerThatFits) {
  const Model model = three_elements();
  Settings settings = flow(model, 1e-5, 1.2);
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 25;
  expect_complete(mesh_of(model, settings), 25);
}

TEST(HighLift, LayersEndInTheGapsThatAreTooNarrow) {
  const Model model = three_elements();
  Settings settings = flow(model, 1e-5, 1.2);
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 36;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.layer_quad_percent, 99.0);
  int ended = 0;
  for (const WallReport& wall : mesh.walls) {
    EXPECT_LT(wall.height_error, 0.02);
    for (const auto& [reason, count] : wall.stops) ended += reason != "layers-reached" ? count : 0;
  }
  EXPECT_GT(ended, 0);  // and each says why
}

// Where the first layer is higher than the gap, no wall is left without a word.
TEST(Gaps, NarrowerThanALayerAreNamed) {
  const Model model = model_of(rectangle(10, 0.3));
  Settings settings = test::coarse_settings();
  settings.size = 0.5;
  settings.first_height = 0.25;
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 4;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  std::size_t told = 0;
  for (const Diagnostic& d : mesh.diagnostics) told += d.code.find("wall-") == 0;
  EXPECT_EQ(told, mesh.walls.size());
}

TEST(Gaps, HeightsThatDoNotFitTheSizeAreNamed) {
  const Model model = model_of(rectangle(10, 10));
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 3.0;
  const MeshResult mesh = mesh_of(model, settings);
  std::vector<std::string> told;  // once for the patch, not for each of its edges
  for (const Diagnostic& d : mesh.diagnostics) {
    if (d.code == "wall-height-missed") told.push_back(d.sentence.english());
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find(" / Face1 and 1 more: first heights"), std::string::npos) << told[0];
}

// What finishes the mesh takes no cell of a layer that was asked for, however long and flat.
TEST(Circle, EveryCellOfEveryLayerStays) {
  BRepBuilderAPI_MakeFace face(gp_Pln(), outline_wire({{-5, -5}, {15, -5}, {15, 5}, {-5, 5}}));
  face.Add(TopoDS::Wire(circle_wire(0, 0, 0.5).Reversed()));
  const Model model = model_of(face.Face());
  Settings settings = test::coarse_settings();
  settings.size = 0.4;
  settings.curvature_angle = 5.0;
  settings.first_height = 0.0005;
  settings.growth = 1.2;
  settings.walls_all = false;
  settings.walls.resize(1);
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].length < 4) settings.walls[0].edges.emplace_back(e);
  }
  settings.end = EndOfGrowth::kLayers;
  for (const int layers : {10, 20, 28}) {
    settings.layers = layers;
    const MeshResult mesh = mesh_of(model, settings);
    ASSERT_EQ(mesh.walls.size(), 1u);
    EXPECT_EQ(mesh.walls[0].layers, layers);
    const std::size_t segments = mesh.edge_segments[mesh.walls[0].edge.index()].size();
    for (int k = 1; k <= layers; ++k) {
      const auto cells = std::count(mesh.quad_layer.begin(), mesh.quad_layer.end(), k);
      EXPECT_EQ(static_cast<std::size_t>(cells), segments) << "layer " << k << " of " << layers;
    }
    EXPECT_EQ(mesh.figures.inverted, 0);
  }
}

// A plate with a hundred holes: rings of quads alone around each.
TEST(Washers, EveryHoleHasItsRings) {
  BRepBuilderAPI_MakeFace face(gp_Pln(), outline_wire({{0, 0}, {200, 0}, {200, 200}, {0, 200}}));
  for (int i = 0; i < 100; ++i) {
    const TopoDS_Wire hole = circle_wire(10 + 20 * (i % 10), 10 + 20 * (i / 10), 4);
    face.Add(TopoDS::Wire(hole.Reversed()));
  }
  const Model model = model_of(face.Face());
  Settings settings = test::coarse_settings();
  settings.size = 2.0;
  settings.first_height = 0.6;
  settings.growth = 1.1;
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 3;
  settings.walls_all = false;
  settings.walls.resize(1);
  std::size_t segments = 0;
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].length < 100) settings.walls[0].edges.emplace_back(e);
  }
  const MeshResult mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.walls.size(), 100u);
  for (const WallReport& wall : mesh.walls)
    segments += mesh.edge_segments[wall.edge.index()].size();
  expect_complete(mesh, 3);
  std::vector<std::size_t> rings(4, 0);
  for (const int layer : mesh.quad_layer) ++rings[static_cast<std::size_t>(std::min(layer, 3))];
  for (int k = 1; k <= 3; ++k) EXPECT_EQ(rings[static_cast<std::size_t>(k)], segments) << k;
}

}  // namespace
}  // namespace advlayers::test
