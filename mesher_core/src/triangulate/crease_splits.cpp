#include "triangulate/crease_splits.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "base/angles.h"
#include "base/directions.h"
#include "boundary/edge_creases.h"

namespace advlayers {
namespace {

using Side = PlanarTriangulation::Side;

constexpr double kSharp = 0.25;      // of the least length asked for, that a fold lies within
constexpr double kNearEnd = 0.12;    // of the edge; an end so near is taken for a point of the fold
constexpr double kNearBorder = 0.8;  // of the least length
constexpr int kBisections = 30;      // to the rounding of the share
constexpr int kMostSplits = 4;       // per triangle at the outset

class CreaseSplitter {
 public:
  CreaseSplitter(const RunContext& context, LiftedTriangulation& sheet)
      : sheet_(sheet), context_(context) {}

  void run() {
    std::vector<int> pending(mesh().triangles().size());
    std::iota(pending.begin(), pending.end(), 0);
    std::size_t budget = kMostSplits * pending.size();
    while (!pending.empty() && budget > 0) {
      context_.check();
      const int t = pending.back();
      pending.pop_back();
      for (int i = 0; i < 3; ++i) {
        if (!split({t, i})) continue;
        --budget;
        pending.insert(pending.end(), sheet_.touched().begin(), sheet_.touched().end());
        pending.push_back(t);
        break;
      }
    }
  }

 private:
  const PlanarTriangulation& mesh() const { return sheet_.mesh(); }

  bool ends_on_fold(int v) const { return sheet_.vertex(v).pole || sheet_.vertex(v).crease; }

  // True where the edge was divided.
  bool split(Side s) {
    if (mesh().segment(s) >= 0 || mesh().triangle(s.t).n[s.i] < 0) return false;
    const int a = mesh().from(s), b = mesh().to(s);
    if (ends_on_fold(a) || ends_on_fold(b)) return false;
    if (angle_between(sheet_.vertex(a).normal, sheet_.vertex(b).normal) < kLeastFoldTurn)
      return false;
    const std::optional<double> share = find_fold(a, b);
    if (!share) return false;
    const double length = std::sqrt(sheet_.squared_length(a, b));
    for (const int end : {a, b}) {
      const double to_end = (end == a ? *share : 1 - *share) * length;
      // A nose that the border itself ends in is seen to by its blunt normals.
      const bool border = sheet_.vertex(end).node.valid();
      if (to_end > (border ? kNearBorder * sheet_.least_size() : kNearEnd * length)) continue;
      if (!border) sheet_.mark_crease(end);
      return false;
    }
    const Vec2 p = mesh().point(a) + *share * (mesh().point(b) - mesh().point(a));
    const int v = sheet_.insert_on(s, p);
    if (v < 0) return false;
    sheet_.mark_crease(v);
    return true;
  }

  // Where along a -> b the normal has turned by the share of its whole turn.
  double where_turned(int a, int b, double share) {
    const Vec3 from = sheet_.vertex(a).normal, to = sheet_.vertex(b).normal;
    double low = 0, high = 1;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + high) / 2;
      const Vec3 normal = at(a, b, middle).normal;
      const double before = angle_between(from, normal), after = angle_between(normal, to);
      (before < share * (before + after) ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  LiftedVertex at(int a, int b, double share) {
    return sheet_.evaluate(mesh().point(a) + share * (mesh().point(b) - mesh().point(a)));
  }

  // Empty where the surface turns gently enough to be followed.
  std::optional<double> find_fold(int a, int b) {
    const double begin = where_turned(a, b, (1 - kMostOfFold) / 2);
    const double end = where_turned(a, b, (1 + kMostOfFold) / 2);
    const double across = (at(a, b, end).point.xyz - at(a, b, begin).point.xyz).norm();
    if (across > kSharp * sheet_.least_size()) return std::nullopt;
    return where_turned(a, b, 0.5);
  }

  LiftedTriangulation& sheet_;
  const RunContext& context_;
};

}  // namespace

void split_creases(const RunContext& context, LiftedTriangulation& sheet) {
  CreaseSplitter(context, sheet).run();
}

}  // namespace advlayers
