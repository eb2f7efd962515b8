#include "sizing/settings.h"

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "coarse_settings.h"
#include "geometry/shapes.h"

namespace advlayers {
namespace {

Settings good() {
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  return settings;
}

const Model& box() {
  static const Model model = test::model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  return model;
}

std::string refusal(const Settings& settings, const Model& model = box()) {
  try {
    check(settings, model);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, SoundOnesPass) {
  EXPECT_EQ(refusal(good()), "");
  Settings full = good();
  full.growth = 1.0;
  full.end = EndOfGrowth::kLayers;
  full.layers = 1;
  full.feature_angle = 0.0;
  full.walls_all = false;
  full.walls = {{{EdgeId(0), EdgeId(1)}, {}, 0.2, 1.1, 3}};
  full.match_edges = {EdgeId(2)};
  full.off_edges = {EdgeId(3)};
  full.faces = {FaceId(5)};
  EXPECT_EQ(refusal(full), "");
}

TEST(Settings, RefusalsNameTheSettingAndItsValue) {
  Settings s = good();
  s.size = 0.0;
  EXPECT_EQ(refusal(s), "size must be > 0 mm, got 0");
  s = good();
  s.first_height = -2.5;
  EXPECT_EQ(refusal(s), "first_height must be > 0 mm, got -2.5");
  s = good();
  s.growth = 0.5;
  EXPECT_EQ(refusal(s), "growth must be >= 1 and <= 10, got 0.5");
  s = good();
  s.end = EndOfGrowth::kLayers;
  EXPECT_EQ(refusal(s), "layers must be >= 1, got 0");
  s = good();
  s.feature_angle = 180.0;
  EXPECT_EQ(refusal(s), "feature_angle must be >= 0 and < 180 deg, got 180");
  s = good();
  s.threads = -1;
  EXPECT_EQ(refusal(s), "threads must be >= 0, got -1");
}

TEST(Settings, NothingThatIsNoNumberPasses) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (double Settings::*member : {&Settings::size, &Settings::first_height, &Settings::growth,
                                     &Settings::feature_angle, &Settings::curvature_angle}) {
      Settings s = good();
      s.*member = bad;
      EXPECT_NE(refusal(s), "");
    }
    Settings s = good();
    s.walls = {{{EdgeId(0)}, {}, bad, {}, {}}};
    EXPECT_NE(refusal(s).find("Edge1"), std::string::npos);
  }
}

TEST(Settings, ASizeBeyondAllMemoryIsRefused) {
  Settings settings = good();
  settings.size = settings.first_height = 1e-4;
  EXPECT_NE(refusal(settings).find("size is too small"), std::string::npos);
  settings.size = 1e-3;  // of 148 mm^2
  EXPECT_NE(refusal(settings).find("size is too small"), std::string::npos);
  settings.faces = {FaceId(0)};  // 30 mm^2
  EXPECT_EQ(refusal(settings), "");
}

TEST(Settings, AHeightBelowWhatCoordinatesTellApartIsRefused) {
  Settings settings = good();
  settings.first_height = 1e-13;
  EXPECT_NE(refusal(settings).find("first_height"), std::string::npos);
  settings.first_height = 1e-7;
  EXPECT_EQ(refusal(settings), "");
  settings.walls_all = false;
  settings.walls = {WallSpec()};
  settings.walls[0].edges = {EdgeId(0)};
  settings.walls[0].first_height = 1e-300;
  EXPECT_NE(refusal(settings).find("1e-300 (Edge1)"), std::string::npos);
}

TEST(Settings, NamesOutOfRangeAreToldWithWhatTheModelHas) {
  Settings s = good();
  s.faces = {FaceId(98)};
  EXPECT_EQ(refusal(s), "faces: there is no Face99, faces of the model: 6");
  s = good();
  s.off_edges = {EdgeId(12)};
  EXPECT_EQ(refusal(s), "off: there is no Edge13, edges of the model: 12");
  s = good();
  s.walls = {{{EdgeId(-1)}, {}, {}, {}, {}}};
  EXPECT_NE(refusal(s), "");
}

TEST(Settings, AnEdgeHasOneConditionOnly) {
  Settings s = good();
  s.walls = {{{EdgeId(4)}, {}, {}, {}, {}}};
  s.off_edges = {EdgeId(4)};
  EXPECT_EQ(refusal(s), "Edge5 is in both walls and off");
  s.off_edges = {};
  s.match_edges = {EdgeId(4)};
  EXPECT_EQ(refusal(s), "Edge5 is in both walls and match");
  s = good();
  s.match_edges = s.off_edges = {EdgeId(1)};
  EXPECT_EQ(refusal(s), "Edge2 is in both match and off");
}

TEST(Settings, AnEdgeIsNotBothInsideItsPatchAndABoundary) {
  Settings s = good();
  s.faces = {FaceId(0), FaceId(1)};
  s.smooth_edges = {EdgeId(4)};
  s.boundary_edges = {EdgeId(4)};
  EXPECT_EQ(refusal(s), "Edge5 is in both boundary and smooth");
  s.boundary_edges = {};
  s.walls = {{{EdgeId(4)}, {}, {}, {}, {}}};
  EXPECT_EQ(refusal(s), "Edge5 is in both walls and smooth");
  s.walls = {};
  s.boundary_edges = {EdgeId(12)};
  EXPECT_EQ(refusal(s), "boundary: there is no Edge13, edges of the model: 12");
}

TEST(Settings, ASmoothEdgeMustHaveTwoFacesThatMeetThere) {
  Settings s = good();
  s.smooth_edges = {EdgeId(0)};
  EXPECT_EQ(refusal(s),
            "smooth: Edge1 must bound its patch: its faces meet at 90 degrees, and 70 is the most "
            "that layers run over");
  const Model round = test::model_of(BRepPrimAPI_MakeSphere(3).Shape());
  for (std::size_t e = 0; e < round.edges().size(); ++e) {
    s.smooth_edges = {EdgeId(e)};
    EXPECT_EQ(refusal(s, round).empty(), !round.edges()[e].degenerate) << edge_name(EdgeId(e));
    s.boundary_edges = std::exchange(s.smooth_edges, {});
    EXPECT_EQ(refusal(s, round).empty(), !round.edges()[e].degenerate) << edge_name(EdgeId(e));
    s.boundary_edges = {};
  }
}

TEST(Settings, TwoEntriesOfAWallKeepToFacesOfTheirOwn) {
  const std::vector<FaceId> beside = box().edges()[0].faces;
  ASSERT_EQ(beside.size(), 2u);
  Settings s = good();
  s.walls = {{{EdgeId(0)}, {beside[0]}, 0.1, {}, {}}, {{EdgeId(0)}, {beside[1]}, 0.2, {}, {}}};
  EXPECT_EQ(refusal(s), "");
  s.walls[1].faces = {beside[0]};
  EXPECT_EQ(refusal(s), "walls: Edge1 is listed twice");
  s.walls[1].faces = {};
  EXPECT_EQ(refusal(s), "walls: Edge1 is listed twice");
}

TEST(Settings, AWallsFaceTouchesItsEdge) {
  const std::vector<FaceId> beside = box().edges()[0].faces;
  Settings s = good();
  for (int f = 0; f < 6; ++f) {
    s.walls = {{{EdgeId(0)}, {FaceId(f)}, {}, {}, {}}};
    const bool touches = FaceId(f) == beside[0] || FaceId(f) == beside[1];
    EXPECT_EQ(refusal(s).empty(), touches);
  }
}

TEST(Settings, APoleIsNoWall) {
  const Model ball = test::model_of(BRepPrimAPI_MakeSphere(2).Shape());
  for (std::size_t e = 0; e < ball.edges().size(); ++e) {
    Settings s = good();
    s.walls = {{{EdgeId(e)}, {}, {}, {}, {}}};
    EXPECT_EQ(refusal(s, ball).empty(), !ball.edges()[e].degenerate);
  }
}

TEST(Settings, HeightsThatChangeNeedAnEdgeWithTwoEnds) {
  const Model cylinder = test::model_of(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  for (std::size_t e = 0; e < cylinder.edges().size(); ++e) {
    Settings settings = good();
    settings.walls_all = false;
    settings.walls.resize(1);
    settings.walls[0].edges = {EdgeId(e)};
    settings.walls[0].end_height = 0.2;
    const bool closed = cylinder.edges()[e].start == cylinder.edges()[e].end;
    EXPECT_EQ(refusal(settings, cylinder).find("two ends") != std::string::npos, closed);
  }
}

}  // namespace
}  // namespace advlayers
