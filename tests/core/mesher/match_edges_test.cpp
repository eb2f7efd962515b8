// Layers beside edges that are no walls: along match edges, and ending at off edges.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>

#include <algorithm>
#include <cmath>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

TopoDS_Face quarter_cylinder() {
  return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), 4), 0, 0.5 * M_PI, 0, 5).Face();
}
TopoDS_Face sphere_window() {
  return BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), 5), 0, 0.9, -0.4, 0.4).Face();
}

struct Shape {
  const char* name;
  TopoDS_Face (*face)();
};

Settings walls_of(const Model& model, std::initializer_list<std::size_t> sides, double height) {
  Settings settings = test::coarse_settings();
  settings.size = 0.5;
  settings.first_height = height;
  settings.growth = 1.25;
  settings.walls_all = false;
  WallSpec spec;
  for (const std::size_t k : sides) spec.edges.push_back(model.faces()[0].loops[0][k].edge);
  settings.walls.push_back(spec);
  return settings;
}

// Heights measured on the mesh, and every wall vertex's layers.
void expect_as_asked(const MeshResult& mesh, int layers) {
  EXPECT_EQ(mesh.figures.inverted, 0);
  ASSERT_FALSE(mesh.walls.empty());
  for (const WallReport& wall : mesh.walls) {
    EXPECT_NEAR(wall.achieved_min, wall.first_height, 0.02 * wall.first_height);
    EXPECT_NEAR(wall.achieved_max, wall.first_height, 0.02 * wall.first_height);
    EXPECT_NEAR(wall.achieved_growth, wall.growth, 0.03 * wall.growth);
    EXPECT_GE(wall.layers, layers) << edge_name(wall.edge);
  }
}

class FourSided : public testing::TestWithParam<Shape> {};

TEST_P(FourSided, StripBetweenMatchEdgesIsAllQuads) {
  const Model model = model_of(GetParam().face());
  for (const auto& sides : {std::initializer_list<std::size_t>{0, 2}, {1, 3}}) {
    for (const double height : {0.02, 1e-5}) {
      const MeshResult mesh = mesh_of(model, walls_of(model, sides, height));
      EXPECT_TRUE(mesh.triangles.empty()) << mesh.triangles.size();
      expect_as_asked(mesh, 10);
      for (const Diagnostic& d : mesh.diagnostics)
        EXPECT_NE(d.severity, Severity::kError) << d.sentence.english();
    }
  }
}

TEST_P(FourSided, OneWallGrowsAllLayersBetweenMatchEdges) {
  const Model model = model_of(GetParam().face());
  for (std::size_t side = 0; side < 4; ++side) {
    Settings settings = walls_of(model, {side}, 0.02);
    settings.end = EndOfGrowth::kLayers;
    settings.layers = 9;
    const MeshResult mesh = mesh_of(model, settings);
    expect_as_asked(mesh, 9);
    for (const int layer : mesh.triangle_layer) EXPECT_EQ(layer, 0);
  }
}

TEST_P(FourSided, OneWallGrowsAllLayersBetweenOffEdges) {
  const Model model = model_of(GetParam().face());
  Settings settings = walls_of(model, {0}, 0.02);
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 9;
  for (const std::size_t k : {1, 2, 3}) {
    settings.off_edges.push_back(model.faces()[0].loops[0][k].edge);
  }
  const MeshResult mesh = mesh_of(model, settings);
  expect_as_asked(mesh, 9);
  // One triangle per layer and end.
  int layered = 0;
  for (const int layer : mesh.triangle_layer) layered += layer > 0;
  EXPECT_LE(layered, 2 * 9);
  EXPECT_LT(mesh.figures.max_angle, 160.0);
}

INSTANTIATE_TEST_SUITE_P(Of, FourSided,
                         testing::Values(Shape{"plane", [] { return rectangle(6, 4); }},
                                         Shape{"cylinder", quarter_cylinder},
                                         Shape{"sphere", sphere_window}, Shape{"spline", saddle}),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(MatchEdges, OfABoxAreSharedWhateverWallIsChosen) {
  const Model model = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  for (std::size_t e = 0; e < 12; ++e) {
    Settings settings = test::coarse_settings();
    settings.size = 0.8;
    settings.first_height = 0.02;
    settings.growth = 1.3;
    settings.end = EndOfGrowth::kLayers;
    settings.layers = 8;
    settings.walls_all = false;
    settings.walls.assign(1, WallSpec());
    settings.walls[0].edges = {EdgeId(e)};
    const MeshResult mesh = mesh_of(model, settings);
    ASSERT_EQ(mesh.walls.size(), 2u);
    expect_as_asked(mesh, 8);
    expect_watertight(mesh);
  }
}

TEST(MatchEdges, TwoHeightsOnOneEdgeAreReported) {
  const Model model = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  // Two walls of one vertex on two faces, of which the edge between is a match edge for both.
  const Face& face = model.faces()[0];
  const EdgeId shared = face.loops[0][0].edge, first = face.loops[0][1].edge;
  const VertexId corner =
      face.loops[0][0].forward ? model.edge(shared).end : model.edge(shared).start;
  EdgeId second;
  for (std::size_t e = 0; e < 12; ++e) {
    const Edge& edge = model.edges()[e];
    const bool touches = edge.start == corner || edge.end == corner;
    if (touches && EdgeId(e) != shared && EdgeId(e) != first) second = EdgeId(e);
  }
  Settings settings = test::coarse_settings();
  settings.size = 0.8;
  settings.first_height = 0.02;
  settings.walls_all = false;
  settings.walls.resize(2);
  settings.walls[0].edges = {first};
  settings.walls[1].edges = {second};
  for (int k = 0; k < 2; ++k) {
    for (const FaceId f : model.edge(shared).faces) {
      const auto& beside = model.edge(settings.walls[k].edges[0]).faces;
      if (std::find(beside.begin(), beside.end(), f) != beside.end()) {
        settings.walls[k].faces = {f};
      }
    }
    settings.walls[k].layers = 5;
  }
  settings.walls[1].first_height = 0.024;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  expect_watertight(mesh);
  ASSERT_EQ(mesh.diagnostics.size(), 1u);
  EXPECT_EQ(mesh.diagnostics[0].code, "match-mean");
  EXPECT_NE(mesh.diagnostics[0].sentence.english().find(edge_name(shared)), std::string::npos);
}

TEST(MatchEdges, TooSlantOnesEndTheLayersAndAreNamed) {
  const Model model = model_of(polygon_face({{0, 0}, {8, 0}, {4, 3}}));
  const MeshResult mesh = mesh_of(model, walls_of(model, {0}, 0.02));
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_EQ(std::count_if(mesh.diagnostics.begin(), mesh.diagnostics.end(),
                          [](const Diagnostic& d) { return d.code == "match-angle"; }),
            2);
}

// Beside a wall that ends early, columns end one after the other.
TEST(Steps, NeighbouringColumnsDifferByOneLayer) {
  const Model model = model_of(polygon_face({{0, 0}, {10, 0}, {20, 0}, {20, 8}, {0, 8}}));
  Settings settings = walls_of(model, {0}, 0.002);
  settings.growth = 1.1;
  settings.walls[0].layers = 3;
  settings.walls.push_back(settings.walls[0]);
  settings.walls[1].edges = {model.faces()[0].loops[0][1].edge};
  settings.walls[1].layers = 12;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  // Layers over each node of the two walls, by x.
  std::vector<int> height(mesh.nodes.size(), 0);
  std::vector<int> root(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    int foot = static_cast<int>(i), layers = 0;
    while (mesh.node_parent[static_cast<std::size_t>(foot)] >= 0) {
      foot = mesh.node_parent[static_cast<std::size_t>(foot)];
      ++layers;
    }
    height[static_cast<std::size_t>(foot)] =
        std::max(height[static_cast<std::size_t>(foot)], layers);
  }
  std::map<double, int> columns;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    if (mesh.nodes[i].y() == 0.0) columns[mesh.nodes[i].x()] = height[i];
  }
  columns.erase(0.0);  // the ends run along match edges
  columns.erase(20.0);
  int before = columns.begin()->second;
  for (const auto& [x, layers] : columns) {
    EXPECT_LE(std::abs(layers - before), 1) << "at x = " << x;
    before = layers;
    EXPECT_GE(layers, 3);
  }
  EXPECT_EQ(columns.begin()->second, 3);
  EXPECT_EQ(std::max_element(columns.begin(), columns.end(),
                             [](const auto& a, const auto& b) { return a.second < b.second; })
                ->second,
            12);
}

}  // namespace
}  // namespace advlayers::test
