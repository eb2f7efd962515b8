// Sizes of edges and faces, segments, clustering, points of refinement, and heights that vary along
// a wall, measured on the mesh.
#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>

#include <algorithm>
#include <cmath>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

class Plate : public testing::Test {
 protected:
  Plate() : model(model_of(rectangle(10, 6))) {
    settings.size = 0.5;
    settings.first_height = 0.05;
    settings.walls_all = false;
  }
  // The edge of the plate on which y = 0.
  EdgeId bottom() const {
    for (std::size_t e = 0; e < 4; ++e) {
      const Edge& edge = model.edges()[e];
      if (model.vertex(edge.start).xyz.y() == 0 && model.vertex(edge.end).xyz.y() == 0) {
        return EdgeId(e);
      }
    }
    return {};
  }
  // Lengths of the mesh edges along it, from its first vertex.
  std::vector<double> segments(const MeshResult& mesh) const {
    std::vector<double> lengths;
    for (const auto& [a, b] : mesh.edge_segments[bottom().index()]) {
      lengths.push_back(
          (mesh.nodes[static_cast<std::size_t>(a)] - mesh.nodes[static_cast<std::size_t>(b)])
              .norm());
    }
    return lengths;
  }
  SizeSpec& size_of_bottom() {
    settings.sizes.emplace_back();
    settings.sizes.back().edges = {bottom()};
    return settings.sizes.back();
  }

  Model model;
  Settings settings = test::coarse_settings();
};

TEST_F(Plate, EdgeTakesItsOwnSize) {
  size_of_bottom().size = 0.1;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  for (const double length : segments(mesh)) EXPECT_NEAR(length, 0.1, 0.011);
}

TEST_F(Plate, EdgeTakesSoManySegments) {
  size_of_bottom().segments = 37;
  const std::vector<double> lengths = segments(mesh_of(model, settings));
  ASSERT_EQ(lengths.size(), 37u);
  for (const double length : lengths) EXPECT_NEAR(length, 10.0 / 37, 1e-9);
}

TEST_F(Plate, ClustersInGeometricSteps) {
  size_of_bottom().segments = 20;
  settings.sizes[0].cluster = 8.0;
  const std::vector<double> lengths = segments(mesh_of(model, settings));
  ASSERT_EQ(lengths.size(), 20u);
  EXPECT_NEAR(lengths.back() / lengths.front(), 8.0, 1e-9);
  for (std::size_t k = 2; k < lengths.size(); ++k) {
    EXPECT_NEAR(lengths[k] / lengths[k - 1], lengths[1] / lengths[0], 1e-9);
  }
}

TEST_F(Plate, ClustersTowardsBothEnds) {
  size_of_bottom().cluster = 8.0;
  settings.sizes[0].both_ends = true;
  const std::vector<double> lengths = segments(mesh_of(model, settings));
  EXPECT_NEAR(lengths.front(), lengths.back(), 1e-9);
  const double most = *std::max_element(lengths.begin(), lengths.end());
  EXPECT_NEAR(most / lengths.front(), 8.0, 1e-9);
  EXPECT_LE(most, 1.1 * settings.size * (1 + 1e-9));
}

TEST_F(Plate, IsFinerAboutAPoint) {
  settings.refinements.push_back({Vec3(4, 3, 0), 0.08, 0.5});
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  double near = 0.0, far = 0.0;  // mean length of mesh edges
  int near_count = 0, far_count = 0;
  for (const auto& [edge, count] : uses_of_edges(mesh)) {
    const Vec3& a = mesh.nodes[static_cast<std::size_t>(edge.first)];
    const Vec3& b = mesh.nodes[static_cast<std::size_t>(edge.second)];
    const double distance = (0.5 * (a + b) - Vec3(4, 3, 0)).norm();
    if (distance < 0.5) near += (a - b).norm(), ++near_count;
    if (distance > 4.0) far += (a - b).norm(), ++far_count;
  }
  ASSERT_GT(near_count, 50);
  EXPECT_NEAR(near / near_count, 0.08, 0.03);
  EXPECT_GT(far / far_count, 0.35);
}

TEST_F(Plate, FirstHeightChangesLinearlyAlongAWall) {
  settings.walls.resize(1);
  settings.walls[0].edges = {bottom()};
  settings.walls[0].end_height = 0.15;
  settings.walls[0].layers = 4;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  ASSERT_EQ(mesh.walls.size(), 1u);
  EXPECT_LT(mesh.walls[0].height_error, 0.02);
  EXPECT_GT(mesh.walls[0].achieved_max, 2.0 * mesh.walls[0].achieved_min);
  EXPECT_NEAR(mesh.walls[0].achieved_growth, settings.growth, 0.03 * settings.growth);
  EXPECT_EQ(mesh.walls[0].layers, 4);
}

TEST_F(Plate, ReportsThicknessAndLayersAskedAndAchieved) {
  settings.walls.resize(1);
  settings.walls[0].edges = {bottom()};
  settings.walls[0].thickness = 0.8;
  settings.walls[0].layers = 6;
  const MeshResult mesh = mesh_of(model, settings);
  ASSERT_EQ(mesh.walls.size(), 1u);
  const WallReport& wall = mesh.walls[0];
  EXPECT_EQ(wall.requested_layers, 6);
  EXPECT_EQ(wall.layers, 6);
  EXPECT_NEAR(wall.thickness, 0.8, 1e-9);
  EXPECT_NEAR(wall.thickness_min, 0.8, 0.02);
  EXPECT_NEAR(wall.thickness_max, 0.8, 0.02);
}

TEST(WallHeights, FollowAspectRatioAndCurvature) {
  const Model model = model_of(BRepPrimAPI_MakeCylinder(4, 9).Shape());
  for (const bool by_angle : {true, false}) {
    Settings settings = test::coarse_settings();
    settings.size = 0.6;
    settings.first_height = 0.05;
    settings.end = EndOfGrowth::kLayers;
    settings.layers = 5;
    settings.walls_all = false;
    settings.walls.resize(1);
    for (std::size_t e = 0; e < model.edges().size(); ++e) {
      const Edge& edge = model.edges()[e];
      if (edge.start == edge.end) settings.walls[0].edges.emplace_back(e);
    }
    (by_angle ? settings.walls[0].turning_angle : settings.walls[0].aspect_ratio) = 1.5;
    if (!by_angle) settings.walls[0].aspect_ratio = 25;
    const MeshResult mesh = mesh_of(model, settings);
    EXPECT_EQ(mesh.figures.inverted, 0);
    ASSERT_EQ(mesh.walls.size(), 4u);
    const int segments = static_cast<int>(mesh.edge_segments[mesh.walls[0].edge.index()].size());
    const double asked = by_angle ? 4 * 1.5 * M_PI / 180 : 2 * M_PI * 4 / segments / 25;
    for (const WallReport& wall : mesh.walls) {
      EXPECT_NEAR(wall.achieved_mean, asked, 0.02 * asked);
      EXPECT_LT(wall.height_error, 0.02);
    }
  }
}

TEST(FaceSizes, HoldOnTheirFaceAlone) {
  const Model model = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  Settings settings = test::coarse_settings();
  settings.size = 0.8;
  settings.first_height = 0.05;
  settings.walls_all = false;
  settings.sizes.resize(1);
  settings.sizes[0].faces = {FaceId(2)};
  settings.sizes[0].size = 0.2;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  expect_watertight(mesh);
  std::vector<int> elements(6, 0);
  for (const FaceId f : mesh.quad_face) ++elements[f.index()];
  const double wanted = model.faces()[2].area / 0.04;
  EXPECT_NEAR(elements[2], wanted, 0.35 * wanted);
}

}  // namespace
}  // namespace advlayers::test
