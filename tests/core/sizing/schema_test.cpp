#include "sizing/schema.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/error.h"
#include "coarse_settings.h"
#include "sizing/resolve_wall.h"

namespace advlayers {
namespace {

template <class Owner>
void expect_sound(const std::vector<Row<Owner>>& rows) {
  static const Owner kStandard{};
  std::set<std::string> keys;
  for (const Row<Owner>& row : rows) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_EQ(std::string(row.doc).back(), '.') << row.key;
    const std::optional<double> standard = row.number(kStandard);
    EXPECT_TRUE(!standard || row.required || row.range.holds(*standard)) << row.key;
  }
}

TEST(Schema, EveryKeyStandsOnceWithADefaultInItsRange) {
  expect_sound(mesh_rows());
  expect_sound(wall_rows());
  expect_sound(size_rows());
  expect_sound(refinement_rows());
}

TEST(Schema, RangesHoldWhatTheySay) {
  const Range above{0.0, 90.0, true};
  EXPECT_FALSE(above.holds(0.0));
  EXPECT_TRUE(above.holds(90.0));
  EXPECT_EQ(above.said("deg").english(), "> 0 and <= 90 deg");
  const Range below{0.0, 180.0, false, true};
  EXPECT_TRUE(below.holds(0.0));
  EXPECT_FALSE(below.holds(180.0));
  EXPECT_EQ(below.said("").english(), ">= 0 and < 180");
  EXPECT_EQ(Range{1.0}.said("mm").english(), ">= 1 mm");
  EXPECT_FALSE(Range().holds(std::nan("")));
  EXPECT_FALSE(Range().holds(HUGE_VAL));
}

// Every number of every table is checked, whoever adds a row.
TEST(Schema, NoNumberOutOfItsRowsRangePasses) {
  for (const Row<WallSpec>& row : wall_rows()) {
    WallSpec wall;
    const auto* number = std::get_if<std::optional<double> WallSpec::*>(&row.member);
    if (number == nullptr) continue;
    wall.*(*number) = row.range.lowest - 1.0;
    EXPECT_THROW(check_ranges(wall, wall_rows()), InvalidInput) << row.key;
    wall.*(*number) = std::nan("");
    EXPECT_THROW(check_ranges(wall, wall_rows()), InvalidInput) << row.key;
  }
}

const WallSpec& plain() {
  static const WallSpec kPlain;
  return kPlain;
}

Settings job() {
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  settings.growth = 2.0;
  return settings;
}

TEST(ResolveWall, SaysWhereLayersEnd) {
  Settings settings = job();
  EXPECT_EQ(resolve_wall(plain(), settings).layers, 0);
  EXPECT_FALSE(resolve_wall(plain(), settings).thickness);
  settings.end = EndOfGrowth::kIsotropic;
  const ResolvedWall isotropic = resolve_wall(plain(), settings);
  EXPECT_EQ(isotropic.end, EndOfGrowth::kIsotropic);
  EXPECT_EQ(isotropic.layers, 4);  // 0.1 0.2 0.4 0.8
  EXPECT_NEAR(*isotropic.thickness, 1.5, 1e-12);
  settings.growth = 1.0;
  EXPECT_FALSE(resolve_wall(plain(), settings).thickness);
}

TEST(ResolveWall, HasNoHeightThatFollowsFromTheMesh) {
  WallSpec spec;
  spec.aspect_ratio = 5.0;
  spec.layers = 3;
  const ResolvedWall wall = resolve_wall(spec, job());
  EXPECT_FALSE(wall.first_height);
  EXPECT_FALSE(wall.thickness);
  EXPECT_EQ(wall.layers, 3);
}

TEST(ResolveWall, RefusesWhatContradictsItself) {
  WallSpec spec;
  spec.thickness = 1e-3;
  EXPECT_THROW(resolve_wall(spec, job()), InvalidInput);
  spec.thickness.reset();
  spec.growth = 50.0;
  EXPECT_THROW(resolve_wall(spec, job()), InvalidInput);
}

}  // namespace
}  // namespace advlayers
