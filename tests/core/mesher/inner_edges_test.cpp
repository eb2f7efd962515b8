// Patches of several faces: layers run across the edges between them, elements lie on one face.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>

#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

Settings smooth_settings_of(double size) {
  Settings settings = settings_of(size);
  settings.feature_angle = 20.0;
  return settings;
}

// The side of a cylinder, of several faces.
TopoDS_Shape split_cylinder(int faces) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(0.2, 0.3, 1)), 5);
  BRepBuilderAPI_MakeWire wire;
  for (int k = 0; k < faces; ++k) {
    wire.Add(
        BRepBuilderAPI_MakeEdge(circle, 2 * M_PI * k / faces, 2 * M_PI * (k + 1) / faces).Edge());
  }
  return BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(gp_Dir(0.2, 0.3, 1)) * 12).Shape();
}

// Every element's corners lie on the trimmed face that it is said to be on.
void expect_on_own_faces(const Model& model, const MeshResult& mesh, double off) {
  Evaluator evaluator(model);
  const auto distance = [&](FaceId face, int node) {
    const Vec3& xyz = mesh.nodes[static_cast<std::size_t>(node)];
    return (evaluator.closest(face, xyz).xyz - xyz).norm();
  };
  for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
    for (const int node : mesh.quads[i]) ASSERT_LE(distance(mesh.quad_face[i], node), off);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const int node : mesh.triangles[i]) ASSERT_LE(distance(mesh.triangle_face[i], node), off);
  }
}

class SplitCylinder : public testing::TestWithParam<int> {};

TEST_P(SplitCylinder, HasTheFiguresOfTheWholeOne) {
  const Settings settings = smooth_settings_of(1.0);
  const Model one = model_of(split_cylinder(1)), model = model_of(split_cylinder(GetParam()));
  const MeshResult whole = mesh_of(one, settings), mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_NEAR(mesh.figures.quad_percent, whole.figures.quad_percent, 1.0);
  EXPECT_NEAR(mesh.figures.angles_45_135_percent, whole.figures.angles_45_135_percent, 1.0);
  // Seven arcs are cut a little finer than one circle.
  EXPECT_NEAR(mesh.figures.nodes, whole.figures.nodes, 0.25 * whole.figures.nodes);
  expect_on_own_faces(model, mesh, 1e-6);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_NEAR(wall.achieved_mean, settings.first_height, 0.02 * settings.first_height);
    EXPECT_NEAR(wall.achieved_growth, settings.growth, 0.03 * settings.growth);
  }
  // Every edge between two faces is covered by mesh edges from end to end.
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].faces.size() != 2) continue;
    double covered = 0.0;
    for (const auto& [a, b] : mesh.edge_segments[e]) {
      covered += (mesh.nodes[static_cast<std::size_t>(a)] - mesh.nodes[static_cast<std::size_t>(b)])
                     .norm();
    }
    EXPECT_NEAR(covered, model.edges()[e].length, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(InFaces, SplitCylinder, testing::Values(2, 3, 7));

std::vector<EdgeId> lines_of(const Model& model) {
  std::vector<EdgeId> lines;
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].start != model.edges()[e].end && model.edges()[e].faces.size() == 2) {
      lines.emplace_back(e);
    }
  }
  return lines;
}

// Layers of the asked height stand on both sides of the edge, on every node of it.
void expect_layers_on_both_sides(const MeshResult& mesh, EdgeId edge) {
  const auto& segments = mesh.edge_segments[edge.index()];
  ASSERT_FALSE(segments.empty());
  for (const auto& [a, b] : segments) {
    int beside = 0;
    for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
      const auto& quad = mesh.quads[q];
      const bool has_both = std::count(quad.begin(), quad.end(), a) > 0 &&
                            std::count(quad.begin(), quad.end(), b) > 0;
      beside += has_both && mesh.quad_layer[q] == 1;
    }
    EXPECT_EQ(beside, 2) << a << " - " << b;
  }
}

TEST(EdgesByHand, ABoundaryPartsFacesThatMeetSmoothly) {
  const Model model = model_of(split_cylinder(3));
  Settings settings = smooth_settings_of(1.0);
  settings.boundary_edges = lines_of(model);
  ASSERT_EQ(settings.boundary_edges.size(), 3u);
  settings.first_height = 0.2;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.patches.size(), 3u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  for (const EdgeId edge : settings.boundary_edges) expect_layers_on_both_sides(mesh, edge);
}

TEST(EdgesByHand, ASmoothEdgeJoinsFacesAndLeavesTheOthersApart) {
  const Model model = model_of(split_cylinder(3));
  Settings settings = smooth_settings_of(1.0);
  settings.feature_angle = 0.0;
  settings.smooth_edges = lines_of(model);
  const MeshResult joined = mesh_of(model, settings);
  EXPECT_EQ(joined.patches.size(), 1u);
  settings.smooth_edges.resize(1);
  EXPECT_EQ(mesh_of(model, settings).patches.size(), 2u);
  settings.smooth_edges.clear();
  settings.feature_angle = 20.0;
  EXPECT_EQ(mesh_of(model, settings).nodes, joined.nodes);
}

// Two squares that lean against each other by the angle [deg].
TopoDS_Shape roof(double angle) {
  BRepBuilderAPI_MakeWire wire;
  const double a = angle * M_PI / 180.0;
  const gp_Pnt ends[3] = {{-8, 0, 0}, {0, 0, 0}, {8 * std::cos(a), 0, 8 * std::sin(a)}};
  for (int k = 0; k < 2; ++k) wire.Add(BRepBuilderAPI_MakeEdge(ends[k], ends[k + 1]).Edge());
  return BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 8, 0)).Shape();
}

class Roof : public testing::TestWithParam<double> {};

TEST_P(Roof, IsMeshedAcrossItsRidgeWithTheHeightsOfAFlatOne) {
  const Model model = model_of(roof(GetParam()));
  Settings settings = smooth_settings_of(0.8);
  settings.feature_angle = 0.0;
  settings.smooth_edges = lines_of(model);
  ASSERT_EQ(settings.smooth_edges.size(), 1u);
  const MeshResult mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.quad_percent, 97.0);
  expect_on_own_faces(model, mesh, 1e-6);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_NEAR(wall.achieved_min, settings.first_height, 0.02 * settings.first_height);
    EXPECT_NEAR(wall.achieved_max, settings.first_height, 0.02 * settings.first_height);
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Roof, testing::Values(15.0, 45.0, 69.0));

// The patch lies on both sides of the edge: it still goes on across the other one.
TEST(EdgesByHand, LayersGrowOnBothSidesOfACutThroughAPatch) {
  const Model model = model_of(split_cylinder(2));
  Settings settings = smooth_settings_of(0.6);
  settings.boundary_edges = {lines_of(model).front()};
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.quad_percent, 97.0);
  expect_layers_on_both_sides(mesh, settings.boundary_edges[0]);
}

TEST(EdgesByHand, TheSeamOfAClosedFaceCanBeAWall) {
  const Model model = model_of(split_cylinder(1));
  Settings settings = smooth_settings_of(0.6);
  for (const CoEdge& coedge : model.faces()[0].loops[0]) {
    if (coedge.seam) settings.boundary_edges.assign(1, coedge.edge);
  }
  ASSERT_EQ(settings.boundary_edges.size(), 1u);
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.quad_percent, 97.0);
  expect_layers_on_both_sides(mesh, settings.boundary_edges[0]);
}

// Four squares about a point; the edge between two of them ends there, inside the patch.
TEST(EdgesByHand, LayersFanOutAboutTheEndOfASlit) {
  BRep_Builder builder;
  TopoDS_Compound squares;
  builder.MakeCompound(squares);
  for (const double x : {-8.0, 0.0}) {
    for (const double y : {-8.0, 0.0}) {
      const gp_Pln plane(gp_Pnt(x, y, 0), gp_Dir(0, 0, 1));
      builder.Add(squares, BRepBuilderAPI_MakeFace(plane, 0, 8, 0, 8).Face());
    }
  }
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(squares);
  sewing.Perform();
  const Model model = model_of(sewing.SewedShape());
  Settings settings = smooth_settings_of(0.8);
  const std::vector<EdgeId> lines = lines_of(model);
  ASSERT_EQ(lines.size(), 4u);
  settings.boundary_edges = {lines[0]};
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.patches[0].events.count("fan"), 0u);
  EXPECT_GT(mesh.figures.quad_percent, 97.0);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_NEAR(wall.achieved_max, settings.first_height, 0.02 * settings.first_height);
  }
}

// An element lies over dozens of faces, and is cut along all the edges between them.
TEST(InnerEdges, FacesFarThinnerThanTheElementsPartThem) {
  constexpr int kStrips = 60;
  BRepBuilderAPI_MakeWire wire;
  for (int k = 0; k < kStrips; ++k) {
    wire.Add(BRepBuilderAPI_MakeEdge(gp_Pnt(0.2 * k, 0, 0), gp_Pnt(0.2 * (k + 1), 0, 0)).Edge());
  }
  const Model model = model_of(BRepPrimAPI_MakePrism(wire.Wire(), gp_Vec(0, 12, 0)).Shape());
  Settings settings = smooth_settings_of(4.0);
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].faces.size() == 1) settings.off_edges.emplace_back(e);
  }
  const MeshResult mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.patches.size(), 1u);
  for (const Diagnostic& diagnostic : mesh.diagnostics) {
    EXPECT_NE(diagnostic.severity, Severity::kError) << diagnostic.sentence.english();
  }
  const double elements = static_cast<double>(mesh.quads.size() + mesh.triangles.size());
  const double edges = static_cast<double>(uses_of_edges(mesh).size());
  EXPECT_DOUBLE_EQ(static_cast<double>(mesh.nodes.size()) - edges + elements, 1.0);
}

// Two triangles of each side of a box, as an STL file has them: the line between them is no edge.
TEST(InnerEdges, FacetsOfOnePlaneLeaveNoTrace) {
  BRep_Builder builder;
  TopoDS_Compound facets;
  builder.MakeCompound(facets);
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(10, 8, 6).Shape(), TopAbs_FACE); it.More();
       it.Next()) {
    std::vector<gp_Pnt> corners;
    for (BRepTools_WireExplorer wire(BRepTools::OuterWire(TopoDS::Face(it.Current()))); wire.More();
         wire.Next()) {
      corners.push_back(BRep_Tool::Pnt(wire.CurrentVertex()));
    }
    for (const std::size_t k : {1u, 2u}) {
      BRepBuilderAPI_MakePolygon outline(corners[0], corners[k], corners[k + 1], true);
      builder.Add(facets, BRepBuilderAPI_MakeFace(outline.Wire()).Face());
    }
  }
  const Model model = read_brep(RunContext(), brep_text(facets), 1e-6);
  ASSERT_EQ(model.faces().size(), 12u);
  EXPECT_TRUE(model.triangular());
  const Model box = model_of(BRepPrimAPI_MakeBox(10, 8, 6).Shape());
  const MeshResult mesh = mesh_of(model, smooth_settings_of(0.8)),
                   whole = mesh_of(box, smooth_settings_of(0.8));
  EXPECT_EQ(mesh.patches.size(), 6u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_NEAR(mesh.figures.quad_percent, whole.figures.quad_percent, 1.0);
  EXPECT_GE(mesh.figures.min_angle, 25.0);  // another triangulation to begin with, another core
  expect_watertight(mesh);
}

TEST(InnerEdges, FilletedBoxIsOnePatchOnWholeFaces) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) {
    fillet.Add(1.5, TopoDS::Edge(it.Current()));
  }
  const Model model = model_of(fillet.Shape());
  const MeshResult mesh = mesh_of(model, smooth_settings_of(0.8));
  ASSERT_EQ(mesh.patches.size(), 1u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  expect_on_own_faces(model, mesh, 1e-6);
  // A closed surface: nodes - edges + faces = 2, with two mesh edges per quad and 1.5 per triangle.
  const double elements = static_cast<double>(mesh.quads.size() + mesh.triangles.size());
  const double edges = 2.0 * static_cast<double>(mesh.quads.size()) +
                       1.5 * static_cast<double>(mesh.triangles.size());
  EXPECT_DOUBLE_EQ(static_cast<double>(mesh.nodes.size()) - edges + elements, 2.0);
}

}  // namespace
}  // namespace advlayers::test
