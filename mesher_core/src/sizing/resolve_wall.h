// What a wall comes to, from its own entry and the settings that hold for all: the one answer for
// the lines beside the walls in the window, for the report, and for whoever asks in Python.
#pragma once

#include <optional>

#include "sizing/wall_spacing.h"

namespace advlayers {

struct ResolvedWall {
  std::optional<double> first_height;  // [mm] none: it follows from the mesh
  std::optional<double> end_height;    // [mm] at the last vertex of each edge, where it differs
  double growth = 1.0;
  EndOfGrowth end = EndOfGrowth::kFrontsClose;
  int layers = 0;                   // that there will be where nothing is in their way; 0: open
  std::optional<double> thickness;  // [mm] of these together, none where open
};

// Throws InvalidInput where the wall contradicts itself, or a number is out of its range.
ResolvedWall resolve_wall(const WallSpec& spec, const Settings& settings);

}  // namespace advlayers
