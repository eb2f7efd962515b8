// The first row keeps its height: where edges are shorter than it is high, on small rings, and in
// the report of walls that have nothing but corners.
#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>

#include <algorithm>

#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

// A rectangle 60 x 30 with two vertices more on its upper side, `apart` from each other.
TopoDS_Face split_plate(double right, double apart) {
  return polygon_face({{0, 0}, {60, 0}, {60, 30}, {right, 30}, {right - apart, 30}, {0, 30}});
}

double least_height_share(const MeshResult& mesh) {
  double least = 1.0;
  for (const WallReport& wall : mesh.walls) {
    if (wall.achieved_max > 0.0) least = std::min(least, wall.achieved_min / wall.first_height);
  }
  return least;
}

TEST(FirstRow, KeepsItsHeightOverShortEdges) {
  for (const double apart : {0.35, 0.3, 0.2, 0.12}) {
    const Model model = model_of(split_plate(31.0, apart));
    Settings settings = settings_of(4.0);
    settings.first_height = 0.4;
    const MeshResult mesh = mesh_of(model, settings);
    EXPECT_EQ(mesh.figures.inverted, 0) << apart;
    EXPECT_GT(least_height_share(mesh), 0.98) << apart;
  }
}

TEST(FirstRow, KeepsItsHeightOnSmallRings) {
  for (const double radius : {5.0, 6.8, 9.0}) {
    const Model model = model_of(disc(radius));
    Settings settings = settings_of(21.0);
    const MeshResult mesh = mesh_of(model, settings);
    EXPECT_EQ(mesh.figures.inverted, 0) << radius;
    EXPECT_GT(least_height_share(mesh), 0.9) << radius;
  }
}

TEST(FirstRow, IsMeasuredSquareToAWallThatHasCornersAlone) {
  const Model model = model_of(BRepPrimAPI_MakeBox(50, 40, 1.6).Shape());
  Settings settings = settings_of(2.0);
  settings.first_height = 0.05;
  const MeshResult mesh = mesh_of(model, settings);
  for (const WallReport& wall : mesh.walls) EXPECT_LT(wall.height_error, 0.01);
  for (const Diagnostic& diagnostic : mesh.diagnostics) {
    EXPECT_NE(diagnostic.code, "wall-height-missed") << diagnostic.sentence.english();
  }
}

}  // namespace
}  // namespace advlayers::test
