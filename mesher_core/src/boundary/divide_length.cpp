#include "boundary/divide_length.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geometry/model.h"

namespace advlayers {

std::vector<double> divide_by_spacing(const std::vector<SpacingSample>& h, int least_count,
                                      EdgeId edge) {
  const double from = h.front().s, to = h.back().s;
  std::vector<double> cuts{from};
  // Segments up to each sample: the integral of ds / h, h linear between samples.
  std::vector<double> shares(h.size(), 0.0);
  double least = h[0].spacing, most = h[0].spacing;
  for (std::size_t i = 1; i < h.size(); ++i) {
    const double ds = h[i].s - h[i - 1].s, dh = h[i].spacing - h[i - 1].spacing;
    const double rise = dh / h[i - 1].spacing;
    const double share = std::abs(rise) < 1e-9 ? ds / h[i - 1].spacing : ds / dh * std::log1p(rise);
    shares[i] = shares[i - 1] + share;
    least = std::min(least, h[i].spacing);
    most = std::max(most, h[i].spacing);
  }
  const double total = shares.back();
  if (!(total < kMostSegments)) {
    throw InvalidInput("{} is too small: it would cut {} into {} segments", "size", edge_name(edge),
                       total);
  }
  const int whole = static_cast<int>(std::ceil(total - kEvenSpread * (1.0 + total)));
  const int n = std::max(least_count, whole);
  const bool uniform = most - least <= kEvenSpread * most;
  std::size_t cell = 1;
  for (int k = 1; k < n; ++k) {
    if (uniform) {
      cuts.push_back(from + (to - from) * k / n);
      continue;
    }
    const double share = total * k / n;
    while (cell + 1 < shares.size() && shares[cell] < share) ++cell;
    const SpacingSample &a = h[cell - 1], &b = h[cell];
    const double ds = b.s - a.s, slope = (b.spacing - a.spacing) / ds;
    const double part = share - shares[cell - 1];
    const bool level = std::abs(slope * part) < 1e-9;
    const double walked = level ? part * a.spacing : a.spacing * std::expm1(slope * part) / slope;
    cuts.push_back(a.s + std::min(walked, ds));
  }
  cuts.push_back(to);
  return cuts;
}

}  // namespace advlayers
