// Patches of several faces: layers run across the edges between them, elements lie on one face.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>

#include <cmath>

#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

Settings settings_of(double size) {
  Settings settings;
  settings.size = size;
  settings.first_height = size / 10;
  settings.growth = 1.2;
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
  const Settings settings = settings_of(1.0);
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

TEST(InnerEdges, FilletedBoxIsOnePatchOnWholeFaces) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer it(box, TopAbs_EDGE); it.More(); it.Next()) {
    fillet.Add(1.5, TopoDS::Edge(it.Current()));
  }
  const Model model = model_of(fillet.Shape());
  const MeshResult mesh = mesh_of(model, settings_of(0.8));
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
