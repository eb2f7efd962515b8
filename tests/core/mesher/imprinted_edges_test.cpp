// Edges inside a face: lines imprinted on it, and those where another face stands on it.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_BuilderAlgo.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <gp_Pln.hxx>

#include <set>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

TopoDS_Shape fused(const std::vector<TopoDS_Shape>& shapes) {
  TopTools_ListOfShape arguments;
  for (const TopoDS_Shape& shape : shapes) arguments.Append(shape);
  BRepAlgoAPI_BuilderAlgo fuse;
  fuse.SetArguments(arguments);
  fuse.Build();
  return fuse.Shape();
}

TopoDS_Shape plate() {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp::Origin(), gp::DZ()), 0, 10, 0, 10).Face();
}

TopoDS_Shape line(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}

Settings ten_layers() {
  Settings settings = test::coarse_settings();
  settings.size = 0.5;
  settings.first_height = 0.05;
  settings.growth = 1.15;
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 10;
  return settings;
}

// Edges of the model, by how many elements use each of their mesh edges.
std::map<int, std::set<std::size_t>> edges_by_uses(const MeshResult& mesh) {
  const auto uses = uses_of_edges(mesh);
  std::map<int, std::set<std::size_t>> edges;
  for (std::size_t e = 0; e < mesh.edge_segments.size(); ++e) {
    for (const auto& segment : mesh.edge_segments[e]) {
      const auto found = uses.find(std::minmax(segment[0], segment[1]));
      edges[found == uses.end() ? 0 : found->second].insert(e);
    }
  }
  return edges;
}

int triangles_in_layers_up_to(const MeshResult& mesh, int layer) {
  int count = 0;
  for (const int of_triangle : mesh.triangle_layer)
    count += of_triangle > 0 && of_triangle <= layer;
  return count;
}

TEST(ImprintedEdges, HaveLayersOnBothSidesAndFansAtTheirEnds) {
  const MeshResult mesh =
      mesh_of(model_of(fused({plate(), line({3, 5, 0}, {7, 5, 0})})), ten_layers());
  const auto edges = edges_by_uses(mesh);
  EXPECT_EQ(edges.at(1).size(), 4u);
  EXPECT_EQ(edges.at(2).size(), 1u);
  EXPECT_EQ(edges.size(), 2u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_EQ(mesh.patches[0].events.at("fan"), 2);
  EXPECT_EQ(triangles_in_layers_up_to(mesh, 2), 0);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_EQ(wall.layers, 10) << edge_name(wall.edge);
    EXPECT_LT(wall.height_error, 0.02) << edge_name(wall.edge);
  }
}

TEST(ImprintedEdges, MayCrossAndRunFromTheBorder) {
  const TopoDS_Shape shape = fused({plate(), line({0, 5, 0}, {8, 5, 0}), line({5, 2, 0}, {5, 8, 0}),
                                    line({1, 1, 0}, {2, 3, 0}), line({2, 3, 0}, {1, 4, 0})});
  const MeshResult mesh = mesh_of(model_of(shape), ten_layers());
  const auto edges = edges_by_uses(mesh);
  EXPECT_EQ(edges.at(2).size(), 6u);
  EXPECT_EQ(edges.size(), 2u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(mesh.figures.quad_percent, 97.0);
}

TEST(ImprintedEdges, KeepASolidWatertight) {
  const TopoDS_Shape shape =
      fused({BRepPrimAPI_MakeCylinder(3, 10).Shape(), line({0, 3, 2}, {0, 3, 8})});
  const MeshResult mesh = mesh_of(model_of(shape), ten_layers());
  EXPECT_EQ(edges_by_uses(mesh).count(0), 0u);
  EXPECT_EQ(mesh.figures.inverted, 0);
  expect_watertight(mesh);
}

TEST(ImprintedEdges, JoinAPlateToTheWallThatStandsOnIt) {
  const gp_Pln upright(gp_Ax3(gp_Pnt(3, 5, 0), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)));
  const TopoDS_Shape wall = BRepBuilderAPI_MakeFace(upright, 0, 4, 0, 3).Face();
  const MeshResult mesh = mesh_of(model_of(fused({plate(), wall})), ten_layers());
  const auto edges = edges_by_uses(mesh);
  EXPECT_EQ(edges.at(1).size(), 7u);
  EXPECT_EQ(edges.at(3).size(), 1u);
  EXPECT_EQ(edges.size(), 2u);
  EXPECT_EQ(mesh.figures.inverted, 0);
}

}  // namespace
}  // namespace advlayers::test
