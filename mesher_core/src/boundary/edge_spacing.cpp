#include "boundary/edge_spacing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/directions.h"
#include "base/error.h"

namespace advlayers {

namespace {

// A sampled cell turns at most this part of what a segment may.
constexpr double kCellPart = 0.25;
constexpr int kMinDepth = 2, kMaxDepth = 12;
// Normals ask for no finer cut than this part of the size or the stretch: where a crease of the
// surface crosses the edge, no cut is fine enough.
constexpr double kNormalFloor = 0.05;
// A bend tighter than this part of the size or the stretch is seen as one that wide. None asks for
// a finer cut than a part of that, or than so many times the edge's tolerance.
constexpr double kBend = 0.01;
constexpr double kFinestBend = 0.25;
constexpr double kNoise = 2.0;
constexpr double kBendChord = 2.0;  // that tells the direction there, over its width
constexpr double kTooShort = 1e-3;  // for a turn to be told from rounding
// An open stretch shorter than this part of the size is one segment, however it turns.
constexpr double kTiny = 0.05;
// Beyond the layers that run along it an edge grows faster: it meets the long edges of their front.
constexpr double kBlendSlope = 1.0;

}  // namespace

EdgeSpacing::EdgeSpacing(Evaluator& evaluator, EdgeId edge, double t_begin, double t_end,
                         const std::vector<Side>& sides, const SpacingLimits& limits)
    : evaluator_(&evaluator), edge_(edge), t_begin_(t_begin), sides_(&sides), limits_(limits) {
  std::vector<double> pieces{t_begin};
  for (const double t : evaluator.edge_pieces(edge)) {
    if (t > pieces.back() && t < t_end) pieces.push_back(t);
  }
  pieces.push_back(t_end);
  const double length = evaluator.edge_length(edge, t_begin, t_end);
  t_end_ = t_end;
  least_by_normals_ = kNormalFloor * std::min(limits.size, length);
  bend_ = kBend * std::min(limits.size, length);
  least_by_curve_ =
      std::max(kFinestBend * bend_,
               std::min(kNoise * evaluator.model().edge(edge).tolerance, least_by_normals_));
  bend_ = std::max(bend_, least_by_curve_);
  samples_.push_back({0.0, limits.size});
  if (limits.open && !limits.sizes->refined() && length < kTiny * limits.size) {
    samples_.push_back({length, limits.size});
    sides_ = nullptr;
    return;
  }
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    // Derivatives from inside the piece: a slight kink between two is no curvature.
    const double inward = 1e-7 * (pieces[i] - pieces[i - 1]);
    refine(station(pieces[i - 1], inward), station(pieces[i], -inward), 0);
  }
  sides_ = nullptr;
}

EdgeSpacing::Station EdgeSpacing::station(double t, double inward) const {
  Station st;
  st.t = t;
  st.s = evaluator_->edge_length(edge_, t_begin_, t);
  st.xyz = evaluator_->edge_point(edge_, t);
  st.tangent = evaluator_->edge_tangent(edge_, t + inward);
  st.size = limits_.size;
  for (const Side& side : *sides_) {
    if (!limits_.sizes->refined()) break;
    st.size = std::min(st.size, limits_.sizes->near(st.xyz, side.face, limits_.size));
  }
  for (const Side& side : *sides_) {
    if (evaluator_->model().face(side.face).kind == SurfaceKind::kPlane) continue;
    const Vec2 uv = evaluator_->edge_uv(side.face, side.coedge, t);
    const SurfaceFrame frame = evaluator_->frame(side.face, uv.x(), uv.y());
    st.normals.push_back(frame.degenerate ? Vec3(Vec3::Zero()) : frame.normal);
  }
  return st;
}

// A curve that runs back within its tolerance still leads on.
EdgeSpacing::Chord EdgeSpacing::chord_about(const Station& at) const {
  const double half = 0.5 * kBendChord * bend_;
  const double from = std::max(t_begin_, evaluator_->edge_parameter(edge_, at.t, -half));
  const double to = std::min(t_end_, evaluator_->edge_parameter(edge_, at.t, half));
  return {evaluator_->edge_point(edge_, to) - evaluator_->edge_point(edge_, from),
          0.5 * (evaluator_->edge_length(edge_, t_begin_, from) +
                 evaluator_->edge_length(edge_, t_begin_, to))};
}

// By its angle, and by how far its middle lies off the curve: l^2 / 8r for a chord l on a radius r.
double EdgeSpacing::spacing_of_turn(double ds, double turn) const {
  if (!(turn > 0.0)) return std::numeric_limits<double>::infinity();
  const double by_angle = ds * limits_.curve_angle / turn;
  return limits_.chord > 0.0 ? std::min(by_angle, std::sqrt(8.0 * limits_.chord * ds / turn))
                             : by_angle;
}

double EdgeSpacing::bend_spacing(const Station& a, const Station& b) const {
  const Chord from = chord_about(a), to = chord_about(b);
  const double turn = angle_between(from.along, to.along);
  return std::max(least_by_curve_, spacing_of_turn(to.middle - from.middle, turn));
}

// The spacing at which a segment between the two would turn as much as it may.
double EdgeSpacing::turn_spacing(const Station& a, const Station& b) const {
  const double ds = b.s - a.s;
  double spacing = std::numeric_limits<double>::infinity();
  if (!(ds > 0.0)) return spacing;
  // A curve may come to a stop at its end (coincident poles): the chord tells its direction there.
  const Vec3 chord = b.xyz - a.xyz;
  const double least = 1e-9 * ds / std::max(std::abs(b.t - a.t), 1e-300);
  const Vec3& from = a.tangent.norm() > least ? a.tangent : chord;
  const Vec3& to = b.tangent.norm() > least ? b.tangent : chord;
  const double turn = angle_between(from, to);
  spacing = spacing_of_turn(ds, turn);
  if (spacing < bend_ || ds < kTooShort * bend_) spacing = bend_spacing(a, b);
  for (std::size_t i = 0; i < a.normals.size(); ++i) {
    if (a.normals[i].isZero() || b.normals[i].isZero()) continue;
    const double normal_turn = angle_between(a.normals[i], b.normals[i]);
    if (!(normal_turn > 0.0)) continue;
    const double by_normals = ds * limits_.normal_angle / normal_turn;
    spacing = std::min(spacing, std::max(by_normals, least_by_normals_));
  }
  return std::max(spacing, limits_.least);
}

void EdgeSpacing::refine(const Station& a, const Station& b, int depth) {
  const Station mid = station(0.5 * (a.t + b.t), 0.0);
  const double left = turn_spacing(a, mid), right = turn_spacing(mid, b);
  const double ds = std::max(mid.s - a.s, b.s - mid.s);
  // A finer place is felt over some sizes: no cell may be wider.
  const bool coarse = ds > kCellPart * std::min({left, right, a.size, mid.size, b.size}) ||
                      (limits_.sizes->refined() && ds > limits_.size);
  if (depth < kMinDepth || (coarse && depth < kMaxDepth)) {
    refine(a, mid, depth + 1);
    refine(mid, b, depth + 1);
    return;
  }
  // Each sample takes the finer of its two cells, and the size of its own place alone: between two
  // it changes with the distance, so that a tiny size at one place takes few segments around it.
  samples_.back().spacing = std::min({samples_.back().spacing, left, a.size});
  if (mid.s > samples_.back().s) {
    samples_.push_back({mid.s, std::min({limits_.size, left, right, mid.size})});
  }
  if (b.s > samples_.back().s) samples_.push_back({b.s, std::min({limits_.size, right, b.size})});
}

void EdgeSpacing::fix(int segments, double ratio, bool both_ends) {
  fixed_ = {segments, ratio, both_ends};
}

// Geometric steps are a spacing that is linear in the length.
int EdgeSpacing::segments_for(double ratio, bool both_ends) const {
  const double larger = std::max(ratio, 1.0 / ratio);
  const double segments = length() / limits_.size *
                          (larger > 1.0 + 1e-9 ? std::log(larger) * larger / (larger - 1.0) : 1.0);
  if (!(segments < kMostSegments)) {
    throw InvalidInput("{} would cut {} into millions of segments", "cluster", edge_name(edge_));
  }
  return std::max(both_ends ? 2 : 1, static_cast<int>(std::ceil(segments - kEvenSpread)));
}

void EdgeSpacing::cut_fixed() {
  if (ends_) {
    EndSegments ends = *ends_;
    cuts_ = cut_with_ends(length(), limits_.size, ends);
    if (count() >= required_) return;
    ends.segments = required_;
    cuts_ = cut_with_ends(length(), limits_.size, ends);
    return;
  }
  const int n = std::max(fixed_.segments, required_);
  const int steps = fixed_.both_ends ? (n - 1) / 2 : n - 1;
  const double growth = steps > 0 ? std::pow(fixed_.ratio, 1.0 / steps) : 1.0;
  cuts_.assign(1, 0.0);
  for (int k = 0; k < n; ++k) {
    cuts_.push_back(cuts_.back() + std::pow(growth, fixed_.both_ends ? std::min(k, n - 1 - k) : k));
  }
  const double scale = length() / cuts_.back();
  for (double& cut : cuts_) cut *= scale;
  cuts_.back() = length();
}

void EdgeSpacing::limit_end(int end, double spacing) {
  end_limit_[end] = std::min(end_limit_[end], spacing);
}

// The wanted spacing between two arc lengths, held to the slope from every sample and the ends.
std::vector<SpacingSample> EdgeSpacing::graded(double from, double to) const {
  const double slope = limits_.sizes->slope();
  std::vector<SpacingSample> h{{from, std::numeric_limits<double>::infinity()}};
  for (const SpacingSample& sample : samples_) {
    if (sample.s <= from) {
      h.front().spacing = sample.spacing;
    } else {
      h.push_back({std::min(sample.s, to), sample.spacing});
      if (sample.s >= to) break;
    }
  }
  h.front().spacing = std::min(h.front().spacing, end_limit_[0]);
  h.back().spacing = std::min(h.back().spacing, end_limit_[1]);
  for (std::size_t i = 1; i < h.size(); ++i) {
    h[i].spacing = std::min(h[i].spacing, h[i - 1].spacing + slope * (h[i].s - h[i - 1].s));
  }
  for (std::size_t i = h.size() - 1; i-- > 0;) {
    h[i].spacing = std::min(h[i].spacing, h[i + 1].spacing + slope * (h[i + 1].s - h[i].s));
  }
  for (SpacingSample& sample : h) {
    const double beyond[2] = {sample.s - from, to - sample.s};
    for (int end = 0; end < 2; ++end) {
      if (layers_.segments[end].empty()) continue;
      sample.spacing =
          std::min(sample.spacing, layers_.segments[end].back() + kBlendSlope * beyond[end]);
    }
  }
  return h;
}

void EdgeSpacing::cut() {
  if (fixed()) return cut_fixed();
  cuts_.assign(1, 0.0);
  for (const double segment : layers_.segments[0]) cuts_.push_back(cuts_.back() + segment);
  std::vector<double> from_end;
  double to = length();
  for (const double segment : layers_.segments[1]) {
    from_end.push_back(to);
    to -= segment;
  }
  if (layers_.closed) {
    cuts_.push_back(to);
  } else {
    cut_between(cuts_.back(), to);
  }
  cuts_.insert(cuts_.end(), from_end.rbegin(), from_end.rend());
}

void EdgeSpacing::cut_between(double from, double to) {
  const std::vector<double> cuts = divide_by_spacing(graded(from, to), required_, edge_);
  cuts_.insert(cuts_.end(), cuts.begin() + 1, cuts.end());
}

void EdgeSpacing::cut_at(const std::vector<double>& shares) {
  cuts_.clear();
  for (const double share : shares) cuts_.push_back(share * length());
  cuts_.back() = length();
}

int EdgeSpacing::free_count() const {
  return count() - static_cast<int>(layers_.segments[0].size() + layers_.segments[1].size());
}

double EdgeSpacing::mean_free_segment() const {
  const std::size_t first = layers_.segments[0].size();
  const double from = cuts_[first], to = cuts_[cuts_.size() - 1 - layers_.segments[1].size()];
  return (to - from) / free_count();
}

void EdgeSpacing::lengthen() {
  require(free_count() + 1);
  cut();
}

double EdgeSpacing::end_segment(int end) const {
  return end == 0 ? cuts_[1] - cuts_[0] : cuts_.back() - cuts_[cuts_.size() - 2];
}

}  // namespace advlayers
