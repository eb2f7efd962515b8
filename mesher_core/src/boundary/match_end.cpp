#include "boundary/match_end.h"

#include <algorithm>
#include <cmath>

#include "sizing/gap_rule.h"

namespace advlayers {
namespace {

// The series that meet one end of the edge.
class SeriesAtEnd {
 public:
  explicit SeriesAtEnd(std::vector<LayerSeries> series) : series_(std::move(series)) {}

  bool any() const { return !series_.empty(); }
  bool crowded() const { return crowded_; }

  // The next layer's length along the edge, and the series' own next heights; 0 where none goes on.
  double step(double room, double& spread) {
    std::vector<double> steps;
    for (LayerSeries& s : series_) {
      if (s.layers <= 0 || s.height >= s.isotropic) continue;
      const double height = height_in_gap(std::min(s.height, s.most), room * s.sine);
      if (height <= 0.0) crowded_ = true;
      if (height <= 0.0) s.layers = 0;
      if (height > 0.0) steps.push_back(height / s.sine);
      s.height *= s.growth;
      if (s.layers != kUntilClosed) s.layers = std::max(0, s.layers - 1);
    }
    if (steps.empty()) return 0.0;
    double mean = 0.0;
    for (const double step : steps) mean += step / static_cast<double>(steps.size());
    for (const double step : steps) spread = std::max(spread, std::abs(step - mean) / step);
    return mean;
  }

 private:
  std::vector<LayerSeries> series_;
  bool crowded_ = false;
};

}  // namespace

LayeredCuts lay_out_layers(double length, std::vector<LayerSeries> begin,
                           std::vector<LayerSeries> end) {
  LayeredCuts cuts;
  SeriesAtEnd ends[2] = {SeriesAtEnd(std::move(begin)), SeriesAtEnd(std::move(end))};
  double room = length;
  while (true) {
    const double steps[2] = {ends[0].step(room, cuts.spread), ends[1].step(room, cuts.spread)};
    if (steps[0] <= 0.0 && steps[1] <= 0.0) break;
    for (int e = 0; e < 2; ++e) {
      if (steps[e] > 0.0) cuts.segments[e].push_back(steps[e]);
    }
    room -= steps[0] + steps[1];
  }
  cuts.closed = ends[0].any() && ends[1].any() && ends[0].crowded() && ends[1].crowded();
  return cuts;
}

}  // namespace advlayers
