#include "sizing/resolve_wall.h"

#include <cmath>

#include "sizing/schema.h"

namespace advlayers {
namespace {

// Layers whose heights stay below `height`; layers that do not grow never reach it: 0.
int layers_until(double first_height, double growth, double height) {
  if (growth <= 1.0 || first_height >= height) return 0;
  return static_cast<int>(std::log(height / first_height) / std::log(growth)) + 1;
}

}  // namespace

ResolvedWall resolve_wall(const WallSpec& spec, const Settings& settings) {
  check_ranges(spec, wall_rows(), "walls: ");
  const WallSpacing spacing = spacing_of(spec, settings);
  const bool fixed = !spacing.rule.aspect_ratio && !spacing.rule.turning_angle;
  ResolvedWall wall;
  wall.end_height = spacing.rule.end_height;
  wall.growth = spacing.growth;
  if (spacing.layers != kUntilClosed) {
    wall.end = EndOfGrowth::kLayers;
    wall.layers = spacing.layers;
  } else if (settings.end == EndOfGrowth::kIsotropic) {
    wall.end = EndOfGrowth::kIsotropic;
    if (fixed) wall.layers = layers_until(spacing.first_height, spacing.growth, settings.size);
  }
  if (!fixed) return wall;
  wall.first_height = spacing.first_height;
  if (wall.layers > 0) {
    wall.thickness = thickness_of(spacing.first_height, spacing.growth, wall.layers);
  }
  return wall;
}

}  // namespace advlayers
