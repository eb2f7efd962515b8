// What a wall has less or other than it was asked for: the one rule for diagnostics, for strict
// jobs and for the window.
#pragma once

#include <string_view>
#include <vector>

#include "base/sentence.h"
#include "mesher/result.h"

namespace advlayers {

struct Shortfall {
  std::string_view code;  // of the diagnostic that says so
  Sentence sentence;
};

inline constexpr std::string_view kWithoutLayers = "wall-without-layers";
inline constexpr std::string_view kShortOfLayers = "wall-short-of-layers";
inline constexpr std::string_view kHeightMissed = "wall-height-missed";

std::vector<Shortfall> shortfalls_of(const WallReport& wall);

// What is said of heights that were missed, once for all such walls of a patch, the worst first: a
// faceted arc is many edges.
Sentence missed_heights(std::vector<const WallReport*> walls);

}  // namespace advlayers
