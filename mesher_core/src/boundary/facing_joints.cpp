#include "boundary/facing_joints.h"

#include <algorithm>
#include <cmath>

namespace advlayers {
namespace {

constexpr int kRounds = 4;  // a new joint may ask for others on the strip beyond
// Joints whose shares of their sides differ by less than this part of the way across face each
// other well enough.
constexpr double kReach = 0.5;

class JointFacer {
 public:
  JointFacer(Evaluator& evaluator, std::vector<std::vector<double>>& joints)
      : evaluator_(evaluator), joints_(joints) {}

  // Returns whether a joint was added.
  bool face(const FourSides& strip) {
    const double across = 0.5 * (strip.lengths[1] + strip.lengths[3]);
    return face(strip.sides[0], strip.lengths[0], strip.sides[2], strip.lengths[2],
                kReach * across);
  }

 private:
  bool face(const std::vector<CoEdge>& a, double length_a, const std::vector<CoEdge>& b,
            double length_b, double reach) {
    const std::vector<double> on_a = shares_on(a, length_a), on_b = shares_on(b, length_b);
    if (on_a.empty() && on_b.empty()) return false;
    std::vector<double> for_a, for_b;
    std::vector<char> taken(on_b.size(), 0);
    const double nearest = reach / std::max(length_a, length_b);
    for (const double share : on_a) {
      // The loop comes back along b.
      std::size_t best = on_b.size();
      for (std::size_t k = 0; k < on_b.size(); ++k) {
        const double off = std::abs(1.0 - on_b[k] - share);
        if (taken[k] || off > nearest) continue;
        if (best == on_b.size() || off < std::abs(1.0 - on_b[best] - share)) best = k;
      }
      if (best == on_b.size()) {
        for_b.push_back(1.0 - share);
      } else {
        taken[best] = 1;
      }
    }
    for (std::size_t k = 0; k < on_b.size(); ++k) {
      if (!taken[k]) for_a.push_back(1.0 - on_b[k]);
    }
    for (const double share : for_a) add(a, share * length_a);
    for (const double share : for_b) add(b, share * length_b);
    return !for_a.empty() || !for_b.empty();
  }

  // Of the joints inside the side, from its begin.
  std::vector<double> shares_on(const std::vector<CoEdge>& side, double length) {
    std::vector<double> shares;
    double walked = 0.0;
    for (const CoEdge& coedge : side) {
      const std::vector<double>& joints = joints_[coedge.edge.index()];
      for (std::size_t k = 1; k < joints.size(); ++k) {
        const std::size_t n = joints.size() - 1;
        const double from = coedge.forward ? joints[k - 1] : joints[n - k];
        const double to = coedge.forward ? joints[k] : joints[n - k + 1];
        walked += evaluator_.edge_length(coedge.edge, from, to);
        shares.push_back(walked / length);
      }
    }
    if (!shares.empty()) shares.pop_back();  // the side's end
    return shares;
  }

  void add(const std::vector<CoEdge>& side, double at) {
    for (const CoEdge& coedge : side) {
      std::vector<double>& joints = joints_[coedge.edge.index()];
      const double length = evaluator_.edge_length(coedge.edge, joints.front(), joints.back());
      if (at < length) {
        const double from_first = coedge.forward ? at : length - at;
        const double t = evaluator_.edge_parameter(coedge.edge, joints.front(), from_first);
        joints.insert(std::upper_bound(joints.begin(), joints.end(), t), t);
        return;
      }
      at -= length;
    }
  }

  Evaluator& evaluator_;
  std::vector<std::vector<double>>& joints_;
};

}  // namespace

void face_joints(const RunContext& context, Evaluator& evaluator,
                 const std::vector<FourSides>& strips, std::vector<std::vector<double>>& joints) {
  JointFacer facer(evaluator, joints);
  for (int round = 0; round < kRounds; ++round) {
    bool added = false;
    for (const FourSides& strip : strips) {
      context.check();
      added = facer.face(strip) || added;
    }
    if (!added) return;
  }
}

}  // namespace advlayers
