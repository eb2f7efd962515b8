// How high the layers of a wall are: what one wall asks for, resolved from its own entry and the
// settings that hold for all.
#pragma once

#include <limits>
#include <optional>

#include "sizing/settings.h"

namespace advlayers {

inline constexpr int kUntilClosed = std::numeric_limits<int>::max();

// First heights that are not the same along the whole wall; at most one is set.
struct HeightRule {
  std::optional<double> end_height;  // [mm] at the last parameter; linear in length from the first
  std::optional<double> aspect_ratio;   // of the local segment's length to the height
  std::optional<double> turning_angle;  // [deg] that the wall turns over one height

  bool varies() const { return end_height || aspect_ratio || turning_angle; }
};

struct WallSpacing {
  double first_height = 0.0;  // [mm]
  double growth = 1.0;
  int layers = kUntilClosed;
  HeightRule rule;
};

// A place on a wall, as the rule asks for it.
struct WallPlace {
  double part = 0.0;       // of the edge's length, 0 at its first parameter
  double segment = 0.0;    // [mm] mean length of the mesh edges beside it
  double curvature = 0.0;  // [1/mm] of the edge
};

// The spacing of a wall: `spec` before `settings`; of first height, growth, layers and thickness
// the one that three others give. Throws InvalidInput where they contradict each other.
WallSpacing spacing_of(const WallSpec& spec, const Settings& settings);

// The first height [mm] there; where a turning angle meets a straight wall, `most`.
double first_height_at(const WallSpacing& spacing, const WallPlace& place, double most);

// The height of `layers` layers together [mm].
double thickness_of(double first_height, double growth, int layers);

}  // namespace advlayers
