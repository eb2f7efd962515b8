#include "triangulate/hilbert_order.h"

#include <algorithm>
#include <utility>

namespace advlayers {
namespace {

constexpr std::uint32_t kCells = 1u << 16;  // per direction
// Keeps what symmetry puts at the ends, the middle and the quarters off the borders of cells.
constexpr double kOffset = 0.31;

std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y) {
  std::uint32_t index = 0;
  for (std::uint32_t s = kCells / 2; s > 0; s /= 2) {
    const std::uint32_t right = (x & s) ? 1 : 0, up = (y & s) ? 1 : 0;
    index += s * s * ((3 * right) ^ up);
    if (!up) {
      if (right) {
        x = kCells - 1 - x;
        y = kCells - 1 - y;
      }
      std::swap(x, y);
    }
  }
  return index;
}

}  // namespace

std::vector<int> hilbert_order(const RunContext& context, const std::vector<Vec2>& points) {
  Vec2 low = points.empty() ? Vec2(0, 0) : points.front(), high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  const double scale = extent > 0 ? (kCells - 1) / extent : 0.0;
  std::vector<std::pair<std::uint32_t, int>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 cell = (points[i] - low) * scale + Vec2::Constant(kOffset);
    keys[i] = {
        hilbert_index(static_cast<std::uint32_t>(cell.x()), static_cast<std::uint32_t>(cell.y())),
        static_cast<int>(i)};
  }
  std::sort(keys.begin(), keys.end(), [&context](const auto& a, const auto& b) {
    context.check();
    return a < b;
  });
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].second;
  return order;
}

}  // namespace advlayers
