#include "mesher/wall_shortfalls.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/model.h"

namespace advlayers {
namespace {

constexpr std::size_t kNamed = 3;  // walls in one warning
// A first height this far from the one asked for, relative to it, is a shortfall.
constexpr double kHeightTolerance = 0.1;

// "collision (3), merged (2)": why columns ended, but for those that are complete.
Sentence reasons_of(const WallReport& wall) {
  Sentence all;
  for (const auto& [reason, count] : wall.stops) {
    if (reason == name_in(kStops, Stop::kLayersReached)) continue;
    const Sentence one("{} ({})", reason, count);
    all = all.empty() ? one : Sentence("{}, {}", all, one);
  }
  return all;
}

}  // namespace

std::vector<Shortfall> shortfalls_of(const WallReport& wall) {
  std::vector<Shortfall> found;
  const bool none = wall.achieved_max <= 0.0 && !(wall.layers > 0);
  if (none || wall.layers < wall.requested_layers) {
    const std::string edge = edge_name(wall.edge), face = face_name(wall.face);
    const Sentence got = none ? Sentence("{} on {} got no layers", edge, face)
                              : Sentence("{} on {} got {} complete layers of {}", edge, face,
                                         wall.layers, wall.requested_layers);
    const Sentence reasons = reasons_of(wall);
    found.push_back({none ? kWithoutLayers : kShortOfLayers,
                     reasons.empty() ? got : Sentence("{}: {}", got, reasons)});
  }
  if (wall.height_error > kHeightTolerance) {
    found.push_back({kHeightMissed, missed_heights({&wall})});
  }
  return found;
}

Sentence missed_heights(std::vector<const WallReport*> walls) {
  std::stable_sort(walls.begin(), walls.end(), [](const WallReport* a, const WallReport* b) {
    return a->height_error > b->height_error;
  });
  double least = walls.front()->achieved_min, most = walls.front()->achieved_max, asked = 0.0;
  for (const WallReport* wall : walls) {
    least = std::min(least, wall->achieved_min);
    most = std::max(most, wall->achieved_max);
    asked += wall->first_height / static_cast<double>(walls.size());
  }
  std::string named;
  for (std::size_t i = 0; i < std::min(walls.size(), kNamed); ++i) {
    named += (i > 0 ? ", " : "") + edge_name(walls[i]->edge) + " / " + face_name(walls[i]->face);
  }
  const long error = std::lround(100.0 * walls.front()->height_error);
  if (walls.size() <= kNamed) {
    return Sentence(
        "{}: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %",
        named, least, most, asked, error);
  }
  return Sentence(
      "{} and {} more: first heights from {} to {} mm, off those asked for ({} mm on average) by "
      "up "
      "to {} %",
      named, walls.size() - kNamed, least, most, asked, error);
}

}  // namespace advlayers
