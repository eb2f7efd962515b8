// Facing sides of strips: as many segments at the same shares of their lengths.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>

#include <algorithm>
#include <cmath>

#include "boundary/discretization.h"
#include "coarse_settings.h"
#include "geometry/shapes.h"

namespace advlayers::test {
namespace {

Model polygon(std::initializer_list<gp_Pnt> corners) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& corner : corners) wire.Add(corner);
  wire.Close();
  return model_of(BRepBuilderAPI_MakeFace(wire.Wire()).Shape());
}

Settings settings_of(double size) {
  Settings settings = test::coarse_settings();
  settings.size = size;
  settings.first_height = 0.1 * size;
  return settings;
}

class Strip : public testing::Test {
 protected:
  explicit Strip(std::initializer_list<gp_Pnt> corners) : model(polygon(corners)) {
    Evaluator evaluator(model);
    sides = *find_four_sides(evaluator, FaceId(0));
  }
  Discretization cut(const Settings& settings, const std::vector<MatchEnd>& match_ends = {}) {
    Evaluator evaluator(model);
    return discretize(RunContext(), evaluator, settings, match_ends, {sides});
  }
  EdgeId edge(std::size_t side) const { return sides.sides[side].front().edge; }

  // Of the nodes inside a side, from its begin, as shares of its length.
  std::vector<double> shares(const Discretization& boundary, std::size_t side) const {
    std::vector<double> shares;
    double walked = 0.0;
    for (const CoEdge& coedge : sides.sides[side]) {
      std::vector<NodeId> nodes = boundary.edges[coedge.edge.index()].nodes;
      if (!coedge.forward) std::reverse(nodes.begin(), nodes.end());
      for (std::size_t k = 1; k < nodes.size(); ++k) {
        walked += (boundary.nodes[nodes[k].index()].xyz - boundary.nodes[nodes[k - 1].index()].xyz)
                      .norm();
        shares.push_back(walked / sides.lengths[side]);
      }
    }
    shares.pop_back();
    return shares;
  }
  // And both ends have as many segments.
  void expect_facing(const Discretization& boundary) const {
    EXPECT_EQ(shares(boundary, 1).size(), shares(boundary, 3).size());
    const std::vector<double> there = shares(boundary, 0), back = shares(boundary, 2);
    ASSERT_EQ(there.size(), back.size());
    for (std::size_t k = 0; k < there.size(); ++k) {
      EXPECT_NEAR(there[k], 1.0 - back[back.size() - 1 - k], 1e-9);
    }
  }

  const Model model;
  FourSides sides;
};

class Slanted : public Strip {
 protected:
  Slanted() : Strip({{0, 0, 0}, {11, 0, 0}, {10.7, 0.4, 0}, {0.2, 0.3, 0}}) {}
};

TEST_F(Slanted, SidesOfOtherLengthsAreCutAlike) { expect_facing(cut(settings_of(0.7))); }

TEST_F(Slanted, AFinerSideMakesTheOtherAsFine) {
  Settings settings = settings_of(0.7);
  SizeSpec finer;
  finer.edges = {edge(0)};
  finer.size = 0.45;
  settings.sizes.push_back(finer);
  const Discretization boundary = cut(settings);
  expect_facing(boundary);
  EXPECT_GE(shares(boundary, 2).size() + 1, std::floor(sides.lengths[0] / (1.1 * 0.45)));
}

TEST_F(Slanted, SegmentsGivenByTheUserStand) {
  Settings settings = settings_of(0.7);
  SizeSpec given;
  given.edges = {edge(0)};
  given.segments = 31;
  settings.sizes.push_back(given);
  EXPECT_EQ(shares(cut(settings), 0).size(), 30U);
}

TEST_F(Slanted, LayersAlongASideStand) {
  const Settings settings = settings_of(0.7);
  MatchEnd match;
  match.edge = edge(0);
  match.wall = edge(1);
  match.face = FaceId(0);
  match.spacing.first_height = 0.05;
  match.spacing.growth = 1.2;
  match.spacing.layers = 4;
  match.max_height = 0.7;
  Evaluator evaluator(model);
  const Discretization alone = discretize(RunContext(), evaluator, settings, {match});
  EXPECT_TRUE(same_cuts(alone, cut(settings, {match})));
}

TEST_F(Slanted, SidesOfVeryDifferentSizesStay) {
  Settings settings = settings_of(0.7);
  SizeSpec finer;
  finer.edges = {edge(0)};
  finer.size = 0.1;
  settings.sizes.push_back(finer);
  const Discretization boundary = cut(settings);
  EXPECT_LT(2 * shares(boundary, 2).size(), shares(boundary, 0).size());
}

// A vertex in the midst of one long side: the other gets a node that faces it.
class Joined : public Strip {
 protected:
  Joined() : Strip({{0, 0, 0}, {4.1, 0, 0}, {11, 0, 0}, {11, 0.3, 0}, {0, 0.3, 0}}) {}
};

TEST_F(Joined, ANodeFacesTheVertex) {
  const Discretization boundary = cut(settings_of(0.7));
  expect_facing(boundary);
  std::size_t at_vertex = 0;
  for (const std::size_t side : {0, 2}) {
    for (const double share : shares(boundary, side)) {
      const double from_left = sides.sides[side].size() == 2 ? share : 1.0 - share;
      if (std::abs(from_left * 11 - 4.1) < 1e-9) ++at_vertex;
    }
  }
  EXPECT_EQ(at_vertex, 2U);
}

// A tiny edge beside a corner: an end has a segment more than the other by itself.
class Blunted : public Strip {
 protected:
  Blunted() : Strip({{0, 0, 0}, {9, 0, 0}, {9, 0.02, 0}, {9, 0.3, 0}, {0, 0.3, 0}}) {}
};

TEST_F(Blunted, EndsHaveAsManySegmentsAndNeighboursDoNotJump) {
  const Discretization boundary = cut(settings_of(0.7));
  expect_facing(boundary);
  for (std::size_t side = 0; side < 4; ++side) {
    std::vector<double> ends = shares(boundary, side);
    ends.insert(ends.begin(), 0.0);
    ends.push_back(1.0);
    for (std::size_t k = 2; k < ends.size(); ++k) {
      const double ratio = (ends[k] - ends[k - 1]) / (ends[k - 1] - ends[k - 2]);
      EXPECT_LT(std::max(ratio, 1 / ratio), 1.5 * (1 + 1e-6)) << side;
    }
  }
}

TEST(FourSides, NeedFourCorners) {
  const Model triangle = polygon({{0, 0, 0}, {3, 0, 0}, {0, 2, 0}});
  Evaluator evaluator(triangle);
  EXPECT_FALSE(find_four_sides(evaluator, FaceId(0)));
}

}  // namespace
}  // namespace advlayers::test
