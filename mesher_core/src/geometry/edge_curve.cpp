#include "geometry/edge_curve.h"

#include <TColStd_Array1OfReal.hxx>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

struct GaussPoint {
  double x, weight;
};
// Gauss-Legendre with eight points on [-1, 1]; the other half by symmetry.
constexpr std::array<GaussPoint, 4> kGauss{{{0.1834346424956498, 0.3626837833783620},
                                            {0.5255324099163290, 0.3137066458778873},
                                            {0.7966664774136267, 0.2223810344533745},
                                            {0.9602898564975363, 0.1012285362903763}}};
constexpr double kLengthError = 1e-13;  // relative
constexpr int kMaxDepth = 30;           // of halving: below the rounding of the length
constexpr double kWithin = 0.1;         // of a span: where its end is told from inside

}  // namespace

EdgeCurve::EdgeCurve(const TopoDS_Edge& shape, const Edge& edge, const Vec3& pole)
    : edge_(&edge), pole_(pole) {
  if (!edge.degenerate) curve_.Initialize(shape);
}

Vec3 EdgeCurve::value(double t) const {
  return edge_->degenerate ? pole_ : to_vec(curve_.Value(t));
}

Vec3 EdgeCurve::tangent(double t) const {
  if (edge_->degenerate) return Vec3::Zero();
  gp_Pnt p;
  gp_Vec d;
  curve_.D1(t, p, d);
  return to_vec(d);
}

double EdgeCurve::curvature(double t) const {
  if (edge_->degenerate) return 0.0;
  gp_Pnt p;
  gp_Vec d1, d2;
  curve_.D2(t, p, d1, d2);
  const double speed = d1.Magnitude();
  return speed > 0.0 ? d1.Crossed(d2).Magnitude() / (speed * speed * speed) : 0.0;
}

double EdgeCurve::gauss(double a, double b) const {
  const double mid = 0.5 * (a + b), half = 0.5 * (b - a);
  double sum = 0.0;
  for (const GaussPoint& g : kGauss) {
    sum += g.weight * (speed(mid - half * g.x) + speed(mid + half * g.x));
  }
  return half * sum;
}

void EdgeCurve::refine(double a, double b, double whole, double floor, int depth) {
  const double mid = 0.5 * (a + b);
  const double left = gauss(a, mid), right = gauss(mid, b);
  const double error = std::abs(left + right - whole);
  if (error > kLengthError * (left + right) && depth < kMaxDepth && mid > a && mid < b &&
      error > floor) {
    refine(a, mid, left, floor, depth + 1);
    refine(mid, b, right, floor, depth + 1);
    return;
  }
  params_.push_back(mid);
  lengths_.push_back(lengths_.back() + left);
  params_.push_back(b);
  lengths_.push_back(lengths_.back() + right);
}

std::vector<double> EdgeCurve::breaks(GeomAbs_Shape continuity) const {
  const int intervals = curve_.NbIntervals(continuity);
  TColStd_Array1OfReal knots(1, intervals + 1);
  curve_.Intervals(knots, continuity);
  std::vector<double> out(knots.begin(), knots.end());
  out.front() = edge_->first;
  out.back() = edge_->last;
  return out;
}

void EdgeCurve::build_table() {
  params_ = {edge_->first};
  lengths_ = {0.0};
  if (edge_->degenerate) return;
  const std::vector<double> knots = breaks(GeomAbs_CN);
  double total = 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) total += gauss(knots[i - 1], knots[i]);
  const double floor = 1e-3 * kLengthError * total;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    if (!(knots[i] > knots[i - 1])) continue;
    refine(knots[i - 1], knots[i], gauss(knots[i - 1], knots[i]), floor, 0);
  }
}

double EdgeCurve::length_at(double t) {
  if (params_.empty()) build_table();
  if (params_.size() < 2) return 0.0;
  const auto above = std::upper_bound(params_.begin(), params_.end(), t);
  const auto cell = std::clamp<std::ptrdiff_t>(above - params_.begin() - 1, 0,
                                               static_cast<std::ptrdiff_t>(params_.size()) - 2);
  const auto i = static_cast<std::size_t>(cell);
  return t == params_[i] ? lengths_[i] : lengths_[i] + gauss(params_[i], t);
}

double EdgeCurve::parameter_at(double length) {
  if (params_.empty()) build_table();
  if (params_.size() < 2 || length <= 0.0) return edge_->first;
  if (length >= lengths_.back()) return edge_->last;
  const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), length);
  const auto i = static_cast<std::size_t>(above - lengths_.begin()) - 1;
  double lo = params_[i], hi = params_[i + 1];
  const double cell = lengths_[i + 1] - lengths_[i];
  double t = lo + (hi - lo) * (length - lengths_[i]) / cell;
  // Newton on a monotone function, held in a shrinking bracket.
  for (int k = 0; k < 60; ++k) {
    const double excess = lengths_[i] + gauss(params_[i], t) - length;
    (excess > 0.0 ? hi : lo) = t;
    const double rate = speed(t);
    double next = rate > 0.0 ? t - excess / rate : lo;
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    if (std::abs(next - t) <= 1e-15 * std::max(std::abs(t), edge_->last - edge_->first))
      return next;
    t = next;
  }
  return t;
}

std::vector<double> EdgeCurve::pieces() const {
  if (edge_->degenerate) return {edge_->first, edge_->last};
  return breaks(GeomAbs_CN);
}

std::vector<double> EdgeCurve::kinks(double angle) const {
  std::vector<double> out;
  if (edge_->degenerate) return out;
  const std::vector<double> knots = breaks(GeomAbs_C1);
  const double reach = 1e-7 * (edge_->last - edge_->first);
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    // Never over the next knot: what turns there is told there.
    const Vec3 before = tangent(knots[i] - std::min(reach, kWithin * (knots[i] - knots[i - 1])));
    const Vec3 after = tangent(knots[i] + std::min(reach, kWithin * (knots[i + 1] - knots[i])));
    if (std::atan2(before.cross(after).norm(), before.dot(after)) > angle) out.push_back(knots[i]);
  }
  return out;
}

}  // namespace advlayers
