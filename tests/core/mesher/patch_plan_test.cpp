#include "mesher/patch_plan.h"

#include <gtest/gtest.h>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <limits>

#include "coarse_settings.h"
#include "geometry/shapes.h"

namespace advlayers::test {
namespace {

class BoxWalls : public testing::Test {
 protected:
  BoxWalls() : model(model_of(BRepPrimAPI_MakeBox(1, 2, 3).Shape())), evaluator(model) {
    settings.size = 0.5;
    settings.first_height = 0.1;
    settings.growth = 1.3;
  }

  WallPlan plan() { return plan_walls(RunContext(), evaluator, settings, {FaceId(0)}); }
  EdgeId edge(std::size_t k) const { return model.face(FaceId(0)).loops[0][k].edge; }

  Model model;
  Evaluator evaluator;
  Settings settings = test::coarse_settings();
};

TEST_F(BoxWalls, GrowFromEveryBoundaryEdgeByDefault) {
  const WallPlan walls = plan();
  EXPECT_EQ(walls.edges.size(), 4u);
  for (const auto& [id, wall] : walls.edges) {
    EXPECT_EQ(wall.condition, EdgeCondition::kWall) << edge_name(id);
    EXPECT_EQ(wall.growth.height, 0.1);
    EXPECT_EQ(wall.growth.ratio, 1.3);
    EXPECT_EQ(wall.growth.layers_left, std::numeric_limits<int>::max());
  }
}

TEST_F(BoxWalls, ListedWallsMakeTheirNeighboursMatchAndTheRestOff) {
  settings.walls_all = false;
  settings.walls.push_back({{edge(0)}, {}, 0.2, std::nullopt, 4});
  const WallPlan walls = plan();
  EXPECT_EQ(walls.edges.at(edge(0)).condition, EdgeCondition::kWall);
  EXPECT_EQ(walls.edges.at(edge(0)).growth.height, 0.2);
  EXPECT_EQ(walls.edges.at(edge(0)).growth.ratio, 1.3);
  EXPECT_EQ(walls.edges.at(edge(0)).growth.layers_left, 4);
  EXPECT_EQ(walls.edges.at(edge(1)).condition, EdgeCondition::kMatch);
  EXPECT_EQ(walls.edges.at(edge(2)).condition, EdgeCondition::kOff);
  EXPECT_EQ(walls.edges.at(edge(3)).condition, EdgeCondition::kMatch);
}

TEST_F(BoxWalls, WallsOfAnotherFaceAreNone) {
  settings.walls_all = false;
  settings.walls.push_back({{edge(0)}, {FaceId(5)}, {}, {}, {}});
  EXPECT_EQ(plan().edges.at(edge(0)).condition, EdgeCondition::kOff);
}

TEST_F(BoxWalls, MatchAndOffOverride) {
  settings.off_edges = {edge(1)};
  settings.match_edges = {edge(2)};
  const WallPlan walls = plan();
  EXPECT_EQ(walls.edges.at(edge(0)).condition, EdgeCondition::kWall);
  EXPECT_EQ(walls.edges.at(edge(1)).condition, EdgeCondition::kOff);
  EXPECT_EQ(walls.edges.at(edge(2)).condition, EdgeCondition::kMatch);
}

TEST_F(BoxWalls, FacesAreGroupedOnceAndInOrder) {
  settings.faces = {FaceId(4), FaceId(1), FaceId(4)};
  const auto patches = group_faces(RunContext(), model, settings);
  ASSERT_EQ(patches.size(), 2u);
  EXPECT_EQ(patches[0], (std::vector<FaceId>{FaceId(1)}));
  EXPECT_EQ(patches[1], (std::vector<FaceId>{FaceId(4)}));
}

// A box with one rounded edge: the round meets its two neighbours smoothly, and the ends at right
// angles.
TEST(PatchPlan, FacesThatMeetSmoothlyAreOnePatch) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 5, 6).Shape();
  BRepFilletAPI_MakeFillet round(box);
  round.Add(1.0, TopoDS::Edge(TopExp_Explorer(box, TopAbs_EDGE).Current()));
  const Model model = model_of(round.Shape());
  ASSERT_EQ(model.faces().size(), 7u);
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  settings.feature_angle = 20.0;
  const auto patches = group_faces(RunContext(), model, settings);
  ASSERT_EQ(patches.size(), 5u);
  std::size_t largest = 0;
  for (const auto& faces : patches) {
    largest = std::max(largest, faces.size());
    EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
  }
  EXPECT_EQ(largest, 3u);
  settings.feature_angle = 0.0;
  EXPECT_EQ(group_faces(RunContext(), model, settings).size(), 7u);
  settings.feature_angle = 100.0;
  EXPECT_EQ(group_faces(RunContext(), model, settings).size(), 1u);
}

TEST(PatchPlan, ASeamIsNoWall) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  Evaluator evaluator(model);
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  for (std::size_t i = 0; i < model.faces().size(); ++i) {
    const bool side = model.faces()[i].kind == SurfaceKind::kCylinder;
    EXPECT_EQ(plan_walls(RunContext(), evaluator, settings, {FaceId(i)}).edges.size(),
              side ? 2u : 1u);
  }
}

}  // namespace
}  // namespace advlayers::test
