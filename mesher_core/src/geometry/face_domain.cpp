#include "geometry/face_domain.h"

#include <algorithm>
#include <cmath>

namespace advlayers {

namespace {

// Largest distance of a curve from its chord, as a part of the face's (u, v) bounds.
constexpr double kChordError = 1e-4;
constexpr int kMinDepth = 2, kMaxDepth = 10;

}  // namespace

FaceDomain::FaceDomain(const Model& model, const Face& face, const UvAt& uv_at) : face_(&face) {
  scale_ = Vec2(1.0 / (face.u_max - face.u_min), 1.0 / (face.v_max - face.v_min));
  for (const auto& loop : face.loops) {
    const std::size_t begin = segments_.size();
    for (const CoEdge& coedge : loop) {
      const Edge& edge = model.edge(coedge.edge);
      const double t_a = coedge.forward ? edge.first : edge.last;
      const double t_b = coedge.forward ? edge.last : edge.first;
      add(coedge, t_a, t_b, uv_at(coedge, t_a), uv_at(coedge, t_b), uv_at, 0);
    }
    // Gaps within the tolerance are closed by moving each segment's start onto the end before it.
    Vec2 previous = segments_.back().b;
    for (std::size_t i = begin; i < segments_.size(); ++i) {
      segments_[i].a = previous;
      previous = segments_[i].b;
    }
  }
  build_bands();
}

void FaceDomain::add(const CoEdge& coedge, double t_a, double t_b, const Vec2& a, const Vec2& b,
                     const UvAt& uv_at, int depth) {
  const double t = 0.5 * (t_a + t_b);
  const Vec2 mid = uv_at(coedge, t);
  const double sagitta = (mid - 0.5 * (a + b)).cwiseProduct(scale_).norm();
  if (depth < kMinDepth || (sagitta > kChordError && depth < kMaxDepth)) {
    add(coedge, t_a, t, a, mid, uv_at, depth + 1);
    add(coedge, t, t_b, mid, b, uv_at, depth + 1);
    return;
  }
  segments_.push_back({a, b, coedge, t_a, t_b});
}

void FaceDomain::build_bands() {
  lo_ = hi_ = segments_.front().a;
  for (const Segment& s : segments_) {
    lo_ = lo_.cwiseMin(s.a).cwiseMin(s.b);
    hi_ = hi_.cwiseMax(s.a).cwiseMax(s.b);
  }
  bands_.resize(std::max<std::size_t>(1, segments_.size() / 4));
  const double per_v = static_cast<double>(bands_.size()) / std::max(hi_.y() - lo_.y(), 1e-300);
  const int last = static_cast<int>(bands_.size()) - 1;
  const auto band = [&](double v) {
    return std::clamp(static_cast<int>((v - lo_.y()) * per_v), 0, last);
  };
  for (std::size_t i = 0; i < segments_.size(); ++i) {
    const Segment& s = segments_[i];
    const int end = band(std::max(s.a.y(), s.b.y()));
    for (int k = band(std::min(s.a.y(), s.b.y())); k <= end; ++k) {
      bands_[static_cast<std::size_t>(k)].push_back(static_cast<int>(i));
    }
  }
}

// Even-odd crossings of the ray along +u.
bool FaceDomain::inside_polygons(const Vec2& p) const {
  const double span = std::max(hi_.y() - lo_.y(), 1e-300);
  const double at = (p.y() - lo_.y()) / span * static_cast<double>(bands_.size());
  const int last = static_cast<int>(bands_.size()) - 1;
  bool inside = false;
  for (const int i : bands_[static_cast<std::size_t>(std::clamp(static_cast<int>(at), 0, last))]) {
    const Segment& s = segments_[static_cast<std::size_t>(i)];
    if ((s.a.y() > p.y()) == (s.b.y() > p.y())) continue;
    const double u = s.a.x() + (p.y() - s.a.y()) / (s.b.y() - s.a.y()) * (s.b.x() - s.a.x());
    if (u > p.x()) inside = !inside;
  }
  return inside;
}

bool FaceDomain::contains(Vec2 p) const {
  const double periods[2] = {face_->u_period, face_->v_period};
  // Round-off on a seam or a natural bound must not throw a point out.
  const Vec2 slack = 1e-9 * (hi_ - lo_);
  for (int k = 0; k < 2; ++k) {
    if (periods[k] > 0.0) p[k] -= periods[k] * std::floor((p[k] - lo_[k] + slack[k]) / periods[k]);
    if (p[k] < lo_[k] - slack[k] || p[k] > hi_[k] + slack[k]) return false;
    p[k] = std::clamp(p[k], lo_[k] + slack[k], hi_[k] - slack[k]);
  }
  return inside_polygons(p);
}

}  // namespace advlayers
