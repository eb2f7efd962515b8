// What a wall has less or other than it was asked for: the one rule for diagnostics, for strict
// jobs and for the window.
#pragma once

#include <vector>

#include "base/sentence.h"
#include "mesher/result.h"

namespace advlayers {

struct Shortfall {
  const char* code;  // of the diagnostic that says so
  Sentence sentence;
};

inline constexpr const char* kWithoutLayers = "wall-without-layers";
inline constexpr const char* kShortOfLayers = "wall-short-of-layers";
inline constexpr const char* kHeightMissed = "wall-height-missed";
inline constexpr const char* kShortfallCodes[] = {kWithoutLayers, kShortOfLayers, kHeightMissed};

std::vector<Shortfall> shortfalls_of(const WallReport& wall);

// What is said of heights that were missed, once for all such walls of a patch, the worst first: a
// faceted arc is many edges.
Sentence missed_heights(std::vector<const WallReport*> walls);

}  // namespace advlayers
