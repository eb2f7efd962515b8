#include "mend/cheapest_triangles.h"

#include <limits>

namespace advlayers {
namespace {

// The chord i -> j cuts off the corners between; `apex` is the third of the triangle on it.
struct Chord {
  double cost = 0.0;
  std::size_t apex = 0;
};

void collect(const std::vector<VertexH>& polygon, const std::vector<std::vector<Chord>>& chords,
             std::size_t i, std::size_t j, std::vector<std::vector<VertexH>>& triangles) {
  if (j < i + 2) return;
  const std::size_t k = chords[i][j].apex;
  triangles.push_back({polygon[i], polygon[k], polygon[j]});
  collect(polygon, chords, i, k, triangles);
  collect(polygon, chords, k, j, triangles);
}

}  // namespace

std::vector<std::vector<VertexH>> cheapest_triangles(
    const std::vector<VertexH>& polygon,
    const std::function<double(const std::array<VertexH, 3>&)>& cost) {
  const std::size_t n = polygon.size();
  std::vector<std::vector<Chord>> chords(n, std::vector<Chord>(n));
  for (std::size_t span = 2; span < n; ++span) {
    for (std::size_t i = 0; i + span < n; ++i) {
      Chord& chord = chords[i][i + span];
      chord.cost = std::numeric_limits<double>::infinity();
      for (std::size_t k = i + 1; k < i + span; ++k) {
        const double sum = chords[i][k].cost + chords[k][i + span].cost +
                           cost({polygon[i], polygon[k], polygon[i + span]});
        if (sum < chord.cost) chord = {sum, k};
      }
    }
  }
  std::vector<std::vector<VertexH>> triangles;
  collect(polygon, chords, 0, n - 1, triangles);
  return triangles;
}

}  // namespace advlayers
