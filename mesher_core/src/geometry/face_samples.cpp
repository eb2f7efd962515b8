#include "geometry/face_samples.h"

#include <algorithm>
#include <cmath>

namespace advlayers {

namespace {

constexpr int kGrid = 16;   // samples per direction over the bounds
constexpr int kStarts = 5;  // samples that Newton starts from
constexpr double kGoldenRatio = 0.6180339887498949;

}  // namespace

FaceSamples::FaceSamples(const Face& face, const FaceSurface& surface, const FaceDomain& domain)
    : surface_(&surface), domain_(&domain) {
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const double u = face.u_min + (face.u_max - face.u_min) * (i + 0.5) / kGrid;
      const double v = face.v_min + (face.v_max - face.v_min) * (j + 0.5) / kGrid;
      samples_.push_back({u, v, surface.value(u, v)});
    }
  }
  for (const FaceDomain::Segment& s : domain.segments()) {
    samples_.push_back({s.a.x(), s.a.y(), surface.value(s.a.x(), s.a.y())});
  }
}

SurfacePoint FaceSamples::closest(FaceId id, const Vec3& xyz, const EdgePointAt& at) const {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(samples_.size());
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    order.emplace_back((samples_[i].xyz - xyz).squaredNorm(), i);
  }
  const auto starts = std::min<std::size_t>(kStarts, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(starts),
                    order.end());
  SurfacePoint best = closest_on_boundary(xyz, at);
  double best_distance = (best.xyz - xyz).norm();
  for (std::size_t k = 0; k < starts; ++k) {
    const Sample& start = samples_[order[k].second];
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
