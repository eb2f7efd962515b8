#include "mesher/missed_heights.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "geometry/model.h"

namespace advlayers {
namespace {

constexpr std::size_t kNamed = 3;  // walls in one warning

}  // namespace

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
