// The classes of a front's corners by their interior angle, as paving has them, and the angles at
// which layers run along an edge that they meet.
#pragma once

#include <array>
#include <cstdint>

#include "base/angles.h"
#include "base/named.h"

namespace advlayers {

enum class CornerClass : std::uint8_t {
  kTip,      // closed by a triangle: halved, it would leave angles below 20 degrees
  kEnd,      // one quad; the row ends there
  kSide,     // two quads; the front goes on
  kCorner,   // three quads, by a fan of kids
  kReversal  // four quads
};

struct CornerRange {
  CornerClass id;
  const char* name;
  double up_to;  // [deg]
};

// The one table of their angles. A bound itself belongs to the class farther from straight.
inline constexpr std::array<CornerRange, 5> kCornerClasses{
    {{CornerClass::kTip, "tip", 40.0},
     {CornerClass::kEnd, "end", 135.0},
     {CornerClass::kSide, "side", 247.5},
     {CornerClass::kCorner, "corner", 315.0},
     {CornerClass::kReversal, "reversal", 360.0}}};
static_assert(in_order(kCornerClasses));

// Of an interior angle [rad], 0 … 2 pi.
constexpr CornerClass corner_class(double angle) {
  for (const CornerRange& range : kCornerClasses) {
    const double bound = range.up_to * kDegree;
    if (angle < bound || (angle == bound && range.up_to < 180.0)) return range.id;
  }
  return CornerClass::kReversal;
}

// The front is as good as straight where it turns no further: its vertices are regular there.
inline constexpr double kRegularTurn = 20.0 * kDegree;

// Layers run along an edge that their wall meets at angles between these; beyond, they end at it as
// at a corner. On a mesh, whose chords lie a little aslant to the curves, some more is allowed:
// what was planned on the curves must not end there.
inline constexpr double kLeastAlong = 45.0, kLargestAlong = 135.0;  // [deg]
inline constexpr double kChordSlack = 3.0;                          // [deg]

constexpr bool layers_run_along(double angle, double slack = 0.0) {
  return angle >= (kLeastAlong - slack) * kDegree && angle <= (kLargestAlong + slack) * kDegree;
}

}  // namespace advlayers
