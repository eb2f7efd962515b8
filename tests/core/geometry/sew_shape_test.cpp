// Sewing: faces without common edges become one surface, under the names that they came with.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include <algorithm>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

TopoDS_Compound compound_of(const std::vector<TopoDS_Shape>& shapes) {
  BRep_Builder builder;
  TopoDS_Compound compound;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

// The faces of a drilled box, each moved by up to `gap` and sharing nothing with the others.
TopoDS_Compound loose_faces(double gap) {
  const TopoDS_Shape solid = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeBox(10, 8, 6).Shape(),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(4, 4, -1), gp_Dir(0, 0, 1)), 2, 10).Shape());
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(solid, TopAbs_FACE); it.More(); it.Next()) {
    gp_Trsf move;
    const double k = static_cast<double>(faces.size() % 3) / 2.0;
    move.SetTranslation(gp_Vec(gap * k, gap * (1 - k), 0) / 2);
    faces.push_back(BRepBuilderAPI_Copy(it.Current()).Shape().Moved(move));
  }
  return compound_of(faces);
}

TopoDS_Shape rectangle(double x0, double y0, double x1, double y1) {
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), x0, x1, y0, y1).Face();
}

Settings settings_of(double size) {
  Settings settings = test::coarse_settings();
  settings.size = size;
  settings.first_height = size / 5;
  return settings;
}

class LooseFaces : public testing::TestWithParam<double> {};

TEST_P(LooseFaces, AreClosedUnderTheNamesOfTheGivenShape) {
  const std::string text = brep_text(loose_faces(GetParam()));
  const Model loose = read_brep(RunContext(), text), model = read_brep(RunContext(), text, 0.05);
  EXPECT_FALSE(loose.closed());
  EXPECT_GT(loose.free_edges(), 0);
  EXPECT_TRUE(model.closed());
  EXPECT_EQ(model.free_edges(), 0);
  EXPECT_EQ(model.given_edges(), loose.edges().size());
  ASSERT_EQ(model.faces().size(), loose.faces().size());
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    EXPECT_EQ(model.faces()[f].kind, loose.faces()[f].kind);
    EXPECT_NEAR(model.faces()[f].area, loose.faces()[f].area, 0.01 * loose.faces()[f].area);
  }
  // Each given edge is a single one now, beside the face that it belonged to, where it was.
  Evaluator before(loose), after(model);
  for (std::size_t e = 0; e < loose.edges().size(); ++e) {
    const std::vector<EdgeId> pieces = model.pieces(EdgeId(e));
    ASSERT_EQ(pieces.size(), 1u) << edge_name(EdgeId(e));
    const Edge &given = loose.edges()[e], &sewn = model.edge(pieces[0]);
    EXPECT_NE(std::find(sewn.faces.begin(), sewn.faces.end(), given.faces[0]), sewn.faces.end());
    EXPECT_NEAR(sewn.length, given.length, 0.1);
    const Vec3 a = before.edge_point(EdgeId(e), 0.5 * (given.first + given.last));
    const Vec3 b = after.edge_point(pieces[0], 0.5 * (sewn.first + sewn.last));
    EXPECT_LT((a - b).norm(), 0.05);
  }
}

TEST_P(LooseFaces, AreMeshedWatertight) {
  const Model model = read_brep(RunContext(), brep_text(loose_faces(GetParam())), 0.05);
  const MeshResult mesh = mesh_of(model, settings_of(1.0));
  expect_watertight(mesh);
  EXPECT_EQ(mesh.figures.inverted, 0);
  ASSERT_EQ(mesh.edge_segments.size(), model.given_edges());
  const auto said = std::find_if(mesh.diagnostics.begin(), mesh.diagnostics.end(),
                                 [](const Diagnostic& d) { return d.code == "sewn"; });
  ASSERT_NE(said, mesh.diagnostics.end());
  EXPECT_EQ(said->sentence.english(),
            "sewing joined " + std::to_string(model.joined_edges()) + " edges; free edges left: 0");
}

INSTANTIATE_TEST_SUITE_P(Gaps, LooseFaces, testing::Values(0.0, 1e-3, 2e-2));

TEST(Sewing, LeavesWhatIsFartherApart) {
  const Model model = read_brep(RunContext(), brep_text(loose_faces(0.4)), 0.05);
  EXPECT_FALSE(model.closed());
}

TEST(Sewing, LeavesASoundSolidAsItIs) {
  const std::string text = brep_text(BRepPrimAPI_MakeCylinder(3, 7).Shape());
  const Model given = read_brep(RunContext(), text), model = read_brep(RunContext(), text, 0.01);
  EXPECT_EQ(model.joined_edges(), 0);
  ASSERT_EQ(model.edges().size(), given.edges().size());
  for (std::size_t e = 0; e < given.edges().size(); ++e) {
    EXPECT_EQ(model.edges()[e].faces, given.edges()[e].faces);
  }
}

// Two short edges lie along a long one, which is cut in three for them.
TEST(Sewing, ALongEdgeIsAllItsPieces) {
  const Model model = read_brep(
      RunContext(),
      brep_text(
          compound_of({rectangle(0, 0, 10, 5), rectangle(0, 5.001, 4, 9), rectangle(4, 5, 8, 9)})),
      0.01);
  std::size_t most = 0;
  EdgeId longest;
  for (std::size_t e = 0; e < model.given_edges(); ++e) {
    const std::vector<EdgeId> pieces = model.pieces(EdgeId(e));
    if (pieces.size() > most) longest = EdgeId(e);
    most = std::max(most, pieces.size());
  }
  ASSERT_EQ(most, 3u);
  Settings settings = settings_of(0.5);
  settings.walls_all = false;
  settings.walls.push_back({{longest}, {}, {}, {}, 1});
  const MeshResult mesh = mesh_of(model, settings);
  double covered = 0.0;
  for (const auto& [a, b] : mesh.edge_segments[longest.index()]) {
    covered += (mesh.nodes[std::size_t(a)] - mesh.nodes[std::size_t(b)]).norm();
  }
  EXPECT_NEAR(covered, 10.0, 0.01);
  for (const WallReport& wall : mesh.walls) EXPECT_LT(wall.edge.index(), model.given_edges());

  // What is said of a piece names an edge that the given shape has.
  ASSERT_GT(model.edges().size(), model.given_edges());
  settings.walls[0].layers = 60;
  std::size_t told = 0;
  for (const Diagnostic& d : mesh_of(model, settings).diagnostics) {
    if (d.code != "wall-short-of-layers") continue;
    ++told;
    EXPECT_LE(std::stoul(d.sentence.english().substr(4)), model.given_edges())
        << d.sentence.english();
  }
  EXPECT_EQ(told, 5u);  // two pieces between two faces, and one of one face
}

TEST(Sewing, JoinsThreeFacesAtOneEdge) {
  const gp_Pln upright(gp_Pnt(0, 5, 0), gp_Dir(0, 1, 0));
  const TopoDS_Shape third = BRepBuilderAPI_MakeFace(upright, 0, 10, 0, 4).Face();
  const Model model = read_brep(
      RunContext(),
      brep_text(compound_of({rectangle(0, 0, 10, 5), rectangle(0, 5.001, 10, 9), third})), 0.01);
  std::size_t most = 0;
  for (const Edge& edge : model.edges()) most = std::max(most, edge.faces.size());
  EXPECT_EQ(most, 3u);
  EXPECT_EQ(model.joined_edges(), 3);
}

}  // namespace
}  // namespace advlayers::test
