// Walls that end where the boundary goes straight on or turns away: their layers run on.
#include <gtest/gtest.h>

#include <algorithm>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"
#include "mesher/walls_run_on.h"

namespace advlayers::test {
namespace {

// The first side is the wall, which ends at the second corner.
struct End {
  const char* name;
  Outline outline;
};
void PrintTo(const End& end, std::ostream* out) { *out << end.name; }

Settings one_wall(const Model& model) {
  Settings settings = coarse_settings();
  settings.size = 8;
  settings.first_height = 0.5;
  settings.growth = 1.2;
  settings.walls_all = false;
  WallSpec wall;
  wall.edges = {model.faces()[0].loops[0][0].edge};
  wall.layers = 6;
  settings.walls.push_back(wall);
  return settings;
}

class WallEnds : public testing::TestWithParam<End> {};

TEST_P(WallEnds, LayersRunOnAlongTheNeighbour) {
  const Model model = model_of(polygon_face(GetParam().outline));
  const MeshResult mesh = mesh_of(model, one_wall(model));
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GE(mesh.figures.min_angle, 18.0);
  ASSERT_EQ(mesh.walls.size(), 1u);  // what was not asked for is not reported
  EXPECT_EQ(mesh.walls[0].layers, 6);
}

TEST_P(WallEnds, EdgesThatAreSwitchedOffStayWithoutLayers) {
  const Model model = model_of(polygon_face(GetParam().outline));
  Settings settings = one_wall(model);
  const EdgeId next = model.faces()[0].loops[0][1].edge;
  settings.off_edges.push_back(next);
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  ASSERT_EQ(mesh.walls.size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(
    Corners, WallEnds,
    testing::Values(End{"Straight", {{0, 0}, {100, 0}, {180, 0}, {180, 100}, {0, 100}}},
                    End{"Step", {{0, 0}, {100, 0}, {100, -80}, {200, -80}, {200, 100}, {0, 100}}},
                    End{"Slope", {{0, 0}, {100, 0}, {200, -50}, {200, 100}, {0, 100}}}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace advlayers::test
