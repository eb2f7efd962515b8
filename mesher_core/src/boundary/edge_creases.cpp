#include "boundary/edge_creases.h"

#include <algorithm>
#include <cmath>

#include "base/directions.h"

namespace advlayers {
namespace {

constexpr int kSamples = 64;     // along the edge
constexpr int kBisections = 30;  // to the rounding of the parameter

class FoldFinder {
 public:
  FoldFinder(Evaluator& evaluator, EdgeId edge, const EdgeSpacing::Side& side)
      : evaluator_(evaluator), edge_(edge), side_(side) {}

  void find(double least, std::vector<double>& folds) {
    const Edge& edge = evaluator_.model().edge(edge_);
    double t_before = edge.first;
    Vec3 before = normal(t_before);
    for (int k = 1; k <= kSamples; ++k) {
      const double t = edge.first + (edge.last - edge.first) * k / kSamples;
      const Vec3 here = normal(t);
      if (!before.isZero() && !here.isZero() && angle_between(before, here) >= kLeastFoldTurn) {
        const double begin = where_turned(t_before, t, before, here, (1 - kMostOfFold) / 2);
        const double end = where_turned(t_before, t, before, here, (1 + kMostOfFold) / 2);
        if (evaluator_.edge_length(edge_, begin, end) < least) {
          folds.push_back(where_turned(t_before, t, before, here, 0.5));
        }
      }
      t_before = t;
      before = here;
    }
  }

 private:
  Vec3 normal(double t) {
    const Vec2 uv = evaluator_.edge_uv(side_.face, side_.coedge, t);
    const SurfaceFrame frame = evaluator_.frame(side_.face, uv.x(), uv.y());
    return frame.degenerate ? Vec3(Vec3::Zero()) : frame.normal;
  }

  double where_turned(double low, double high, const Vec3& from, const Vec3& to, double share) {
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + high) / 2;
      const Vec3 at = normal(middle);
      const double before = angle_between(from, at), after = angle_between(at, to);
      (before < share * (before + after) ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  Evaluator& evaluator_;
  EdgeId edge_;
  const EdgeSpacing::Side& side_;
};

}  // namespace

std::vector<double> edge_creases(Evaluator& evaluator, EdgeId edge,
                                 const std::vector<EdgeSpacing::Side>& sides, double least) {
  std::vector<double> folds;
  for (const EdgeSpacing::Side& side : sides) {
    if (evaluator.model().face(side.face).kind != SurfaceKind::kOther) continue;
    FoldFinder(evaluator, edge, side).find(least, folds);
  }
  std::sort(folds.begin(), folds.end());
  const Edge& whole = evaluator.model().edge(edge);
  std::vector<double> apart;
  for (const double t : folds) {
    const double before = apart.empty() ? whole.first : apart.back();
    const bool alone = evaluator.edge_length(edge, before, t) > least &&
                       evaluator.edge_length(edge, t, whole.last) > least;
    if (alone) apart.push_back(t);
  }
  return apart;
}

}  // namespace advlayers
