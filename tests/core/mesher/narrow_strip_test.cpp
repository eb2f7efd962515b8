// Faces too narrow for layers: rows of quads between facing sides that are cut alike.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>

#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

// With a fillet on each edge.
TopoDS_Shape rounded_box(double radius) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 7, 4).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
    fillet.Add(radius, TopoDS::Edge(edge.Current()));
  }
  return fillet.Shape();
}

TopoDS_Shape polygon(std::initializer_list<gp_Pnt> corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire()).Shape();
}

std::size_t segments_on(const MeshResult& mesh, EdgeId edge) {
  return mesh.edge_segments[edge.index()].size();
}

int triangles_on(const MeshResult& mesh, FaceId face) {
  return static_cast<int>(std::count(mesh.triangle_face.begin(), mesh.triangle_face.end(), face));
}

// The edges of a face's only loop, the longest first and from there on in order.
std::vector<EdgeId> from_longest(const Model& model, FaceId face) {
  std::vector<EdgeId> edges;
  for (const CoEdge& coedge : model.face(face).loops.front()) edges.push_back(coedge.edge);
  std::rotate(edges.begin(),
              std::max_element(edges.begin(), edges.end(),
                               [&](EdgeId a, EdgeId b) {
                                 return model.edge(a).length < model.edge(b).length * (1 - 1e-9);
                               }),
              edges.end());
  return edges;
}

class Fillets : public testing::TestWithParam<double> {};  // radius

TEST_P(Fillets, AreRowsOfQuadsAndTheirLongEdgesAreCutAlike) {
  const Model model = model_of(rounded_box(GetParam()));
  Settings settings = settings_of(1.0);
  settings.first_height = 0.3;
  const MeshResult mesh = mesh_of(model, settings);
  expect_watertight(mesh);
  EXPECT_EQ(mesh.figures.inverted, 0);
  int fillets = 0;
  for (std::size_t i = 0; i < model.faces().size(); ++i) {
    if (model.faces()[i].kind != SurfaceKind::kCylinder) continue;
    const std::vector<EdgeId> edges = from_longest(model, FaceId(i));
    ASSERT_EQ(edges.size(), 4U);
    ++fillets;
    EXPECT_EQ(segments_on(mesh, edges[0]), segments_on(mesh, edges[2])) << face_name(FaceId(i));
    EXPECT_EQ(triangles_on(mesh, FaceId(i)), 0) << face_name(FaceId(i));
  }
  EXPECT_EQ(fillets, 12);
}

TEST_P(Fillets, AreTheSameTurnedMirroredAndScaled) {
  const TopoDS_Shape box = rounded_box(GetParam());
  Settings settings = settings_of(1.0);
  settings.first_height = 0.3;
  const MeshResult straight = mesh_of(model_of(box), settings);
  gp_Trsf turned, mirrored, scaled;
  turned.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
  mirrored.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0.2, 0.1)));
  scaled.SetScale(gp_Pnt(0, 0, 0), 1000);
  for (const gp_Trsf& move : {turned, mirrored, scaled}) {
    Settings moved = settings;
    moved.size *= std::abs(move.ScaleFactor());
    moved.first_height *= std::abs(move.ScaleFactor());
    const MeshResult mesh = mesh_of(model_of(BRepBuilderAPI_Transform(box, move).Shape()), moved);
    for (std::size_t e = 0; e < straight.edge_segments.size(); ++e) {
      EXPECT_EQ(mesh.edge_segments[e].size(), straight.edge_segments[e].size());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, Fillets, testing::Values(0.04, 0.2, 0.35));

TEST(NarrowStrip, LayersGrowWhereTheyHaveRoom) {
  const Model model = model_of(polygon({{0, 0, 0}, {12, 0, 0}, {12, 0.5, 0}, {0, 0.5, 0}}));
  Settings settings = settings_of(1.0);
  settings.first_height = 0.1;
  const MeshResult mesh = mesh_of(model, settings);
  for (const WallReport& wall : mesh.walls) {
    if (model.edge(wall.edge).length < 1.0) continue;
    EXPECT_GE(wall.layers, 1);
    EXPECT_NEAR(wall.achieved_mean, 0.1, 1e-3);
  }
}

TEST(NarrowStrip, LayersRunAlongItFromAWallAtItsEnd) {
  const Model model = model_of(polygon({{0, 0, 0}, {12, 0, 0}, {12, 1.5, 0}, {0, 1.5, 0}}));
  Settings settings = settings_of(1.0);
  settings.first_height = 0.8;
  settings.growth = 1.02;
  settings.walls_all = false;
  WallSpec wall;
  wall.edges.push_back(from_longest(model, FaceId(0))[1]);
  wall.layers = 5;
  settings.walls.push_back(wall);
  const MeshResult mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.walls.size(), 1U);
  EXPECT_EQ(mesh.walls[0].layers, 5);
  EXPECT_NEAR(mesh.walls[0].achieved_mean, 0.8, 8e-3);
}

TEST(NarrowStrip, ReportsThatItsWallsHaveNoRoom) {
  const Model model = model_of(polygon({{0, 0, 0}, {12, 0, 0}, {12, 0.3, 0}, {0, 0.3, 0}}));
  Settings settings = settings_of(1.0);
  settings.first_height = 0.2;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_TRUE(mesh.triangles.empty());
  for (const int layer : mesh.quad_layer) EXPECT_EQ(layer, 0);
  ASSERT_EQ(mesh.walls.size(), 4U);
  for (const WallReport& wall : mesh.walls) {
    EXPECT_EQ(wall.layers, 0);
    EXPECT_GT(wall.stops.at("collision"), 0);
  }
}

}  // namespace
}  // namespace advlayers::test
