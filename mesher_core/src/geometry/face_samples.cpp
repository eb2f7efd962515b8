#include "geometry/face_samples.h"

#include <algorithm>
#include <cmath>

#include "base/golden_ratio.h"

namespace advlayers {

namespace {

// Samples per direction over the bounds: more where the surface winds, as a thread does, so that a
// chord between two would miss a part of the way.
constexpr int kGrid = 16, kMostGrid = 256;
constexpr double kMissed = 1.05;  // length with twice the samples, over that with these
constexpr int kStarts = 5;        // samples that Newton starts from

// Of a line across the face, through its middle; `share` from 0 to 1 gives its points.
template <class PointAt>
int samples_along(const PointAt& point_at) {
  const auto length = [&](int count) {
    double sum = 0;
    Vec3 last = point_at(0.0);
    for (int k = 1; k <= count; ++k) {
      const Vec3 next = point_at(static_cast<double>(k) / count);
      sum += (next - last).norm();
      last = next;
    }
    return sum;
  };
  int count = kGrid;
  while (count < kMostGrid && length(2 * count) > kMissed * length(count)) count *= 2;
  return count;
}

}  // namespace

FaceSamples::FaceSamples(const Face& face, const FaceSurface& surface, const FaceDomain& domain)
    : surface_(&surface), domain_(&domain) {
  const auto u_at = [&](double share) { return face.u_min + (face.u_max - face.u_min) * share; };
  const auto v_at = [&](double share) { return face.v_min + (face.v_max - face.v_min) * share; };
  const int along_u = samples_along([&](double s) { return surface.value(u_at(s), v_at(0.5)); });
  const int along_v = samples_along([&](double s) { return surface.value(u_at(0.5), v_at(s)); });
  rows_ = static_cast<std::size_t>(along_u);
  columns_ = static_cast<std::size_t>(along_v);
  for (int i = 0; i < along_u; ++i) {
    for (int j = 0; j < along_v; ++j) {
      const double u = u_at((i + 0.5) / along_u), v = v_at((j + 0.5) / along_v);
      samples_.push_back({u, v, surface.value(u, v)});
    }
  }
  for (const FaceDomain::Segment& s : domain.segments()) {
    samples_.push_back({s.a.x(), s.a.y(), surface.value(s.a.x(), s.a.y())});
  }
}

// The samples nearest to a point; and, of the grid, those with none nearer beside them: where the
// surface comes by several times, as a thread does, the nearest samples may all be of one turn.
std::vector<std::size_t> FaceSamples::starts(const Vec3& xyz) const {
  std::vector<std::pair<double, std::size_t>> all, dips;
  all.reserve(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    all.emplace_back((samples_[i].xyz - xyz).squaredNorm(), i);
  }
  for (std::size_t i = 0; i < rows_ * columns_; ++i) {
    const std::size_t column = i % columns_;
    const bool dip = (column == 0 || all[i].first <= all[i - 1].first) &&
                     (column + 1 == columns_ || all[i].first <= all[i + 1].first) &&
                     (i < columns_ || all[i].first <= all[i - columns_].first) &&
                     (i + columns_ >= rows_ * columns_ || all[i].first <= all[i + columns_].first);
    if (dip) dips.push_back(all[i]);
  }
  std::vector<std::size_t> chosen;
  for (auto* from : {&all, &dips}) {
    const auto count = std::min<std::size_t>(kStarts, from->size());
    const auto end = from->begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(from->begin(), end, from->end());
    for (auto it = from->begin(); it != end; ++it) {
      const bool known = std::find(chosen.begin(), chosen.end(), it->second) != chosen.end();
      if (!known) chosen.push_back(it->second);
    }
  }
  return chosen;
}

SurfacePoint FaceSamples::closest(FaceId id, const Vec3& xyz, const EdgePointAt& at) const {
  SurfacePoint best = closest_on_boundary(xyz, at);
  double best_distance = (best.xyz - xyz).norm();
  for (const std::size_t i : starts(xyz)) {
    const Sample& start = samples_[i];
    SurfacePoint foot{id, start.u, start.v, start.xyz};
    if (!surface_->project(xyz, foot.u, foot.v, foot.xyz)) continue;
    const double distance = (foot.xyz - xyz).norm();
    if (distance >= best_distance || !domain_->contains({foot.u, foot.v})) continue;
    best = foot;
    best_distance = distance;
  }
  best.face = id;
  best.xyz = surface_->value(best.u, best.v);
  return best;
}

// The nearest chord of the boundary, then a golden-section search on the curves around it.
SurfacePoint FaceSamples::closest_on_boundary(const Vec3& xyz, const EdgePointAt& at) const {
  const std::vector<FaceDomain::Segment>& segments = domain_->segments();
  const std::size_t first = samples_.size() - segments.size();
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Vec3& a = samples_[first + i].xyz;
    const Vec3& b = samples_[first + (i + 1) % segments.size()].xyz;
    const Vec3 ab = b - a;
    const double along = ab.squaredNorm() > 0.0 ? (xyz - a).dot(ab) / ab.squaredNorm() : 0.0;
    order.emplace_back((a + std::clamp(along, 0.0, 1.0) * ab - xyz).squaredNorm(), i);
  }
  const auto starts = std::min<std::size_t>(3, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(starts),
                    order.end());
  SurfacePoint best;
  double best_distance = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < starts; ++k) {
    const FaceDomain::Segment& s = segments[order[k].second];
    double lo = s.t_a, hi = s.t_b;
    const auto distance_at = [&](double t) { return (at(s.coedge, t).xyz - xyz).norm(); };
    double left = hi - kGoldenRatio * (hi - lo), right = lo + kGoldenRatio * (hi - lo);
    double d_left = distance_at(left), d_right = distance_at(right);
    for (int i = 0; i < 60; ++i) {
      if (d_left <= d_right) {
        hi = right;
        right = left;
        d_right = d_left;
        left = hi - kGoldenRatio * (hi - lo);
        d_left = distance_at(left);
      } else {
        lo = left;
        left = right;
        d_left = d_right;
        right = lo + kGoldenRatio * (hi - lo);
        d_right = distance_at(right);
      }
    }
    for (const double t : {s.t_a, 0.5 * (lo + hi), s.t_b}) {
      const SurfacePoint p = at(s.coedge, t);
      if ((p.xyz - xyz).norm() >= best_distance) continue;
      best_distance = (p.xyz - xyz).norm();
      best = p;
    }
  }
  return best;
}

}  // namespace advlayers
