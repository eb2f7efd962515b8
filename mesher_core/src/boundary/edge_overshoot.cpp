#include "boundary/edge_overshoot.h"

#include <algorithm>
#include <array>

#include "base/golden_ratio.h"

namespace advlayers {
namespace {

constexpr double kLongest = 0.1;  // of the length, out and back
constexpr int kSamples = 100;     // along the edge, where it may run back
constexpr int kSections = 60;     // of an interval in search of the nearest point
// An edge whose tolerance is less than this part of its length has no room to run back.
constexpr double kTight = 1e-6;

class Overshoot {
 public:
  Overshoot(Evaluator& evaluator, EdgeId edge) : evaluator_(evaluator), edge_(edge) {}

  // `end`, or where the curve comes by it for the last time on its way to `far_end`.
  double return_to(double end, double far_end) const {
    const double near = evaluator_.model().edge(edge_).tolerance;
    const Vec3 place = evaluator_.edge_point(edge_, end);
    std::array<double, kSamples + 1> away;
    for (int k = 0; k <= kSamples; ++k) away[k] = distance(place, at(end, far_end, k));
    for (int k = kSamples - 1; k > 0; --k) {
      if (away[k] > away[k - 1] || away[k] > away[k + 1]) continue;
      const double t = nearest(place, at(end, far_end, k - 1), at(end, far_end, k + 1));
      if (distance(place, t) <= near) return t;
    }
    return end;
  }

 private:
  static double at(double end, double far_end, int k) {
    return end + (far_end - end) * k / kSamples;
  }
  double distance(const Vec3& place, double t) const {
    return (evaluator_.edge_point(edge_, t) - place).norm();
  }
  double nearest(const Vec3& place, double low, double high) const {
    for (int i = 0; i < kSections; ++i) {
      const double a = high - kGoldenRatio * (high - low), b = low + kGoldenRatio * (high - low);
      if (distance(place, a) < distance(place, b)) {
        high = b;
      } else {
        low = a;
      }
    }
    return (low + high) / 2;
  }

  Evaluator& evaluator_;
  EdgeId edge_;
};

}  // namespace

EdgeExtent extent_without_overshoot(Evaluator& evaluator, EdgeId id) {
  const Edge& edge = evaluator.model().edge(id);
  const EdgeExtent whole{edge.first, edge.last};
  if (edge.degenerate || edge.tolerance < kTight * edge.length) return whole;
  const double reach = kLongest * edge.length;
  const Overshoot overshoot(evaluator, id);
  return {overshoot.return_to(edge.first, evaluator.edge_parameter(id, edge.first, reach)),
          overshoot.return_to(edge.last,
                              evaluator.edge_parameter(id, edge.first, edge.length - reach))};
}

}  // namespace advlayers
