#include "layers/layer_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/angles.h"
#include "base/directions.h"
#include "layers/chain_end.h"
#include "layers/concave_scaling.h"
#include "sizing/gap_rule.h"

namespace advlayers {
namespace {

constexpr double kCurved = 15.0 * kDegree;  // that an edge turns with the surface
constexpr double kLongestOfEdge = 1.2;      // height over such an edge's length

class HeightSetter {
 public:
  explicit HeightSetter(PlanDraft& draft) : draft_(draft) {}

  void run() {
    measure();
    cap_by_gaps();
  }

 private:
  static std::size_t index(int i) { return PlanDraft::index(i); }

  void measure() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      const FrontNode& node = draft_.front[i];
      if (!node.active || (node.prev < 0 && node.next < 0)) continue;
      draft_.plan.shapes[index(i)] = node_shape(draft_.mesh, draft_.front, i);
      draft_.heights[index(i)] =
          std::min({node.growth.height, draft_.state.max_height, most_height(i)});
    }
    draft_.drop_lone_nodes(Stop::kNeighbour);
  }

  // Where the front's edges are short for the sake of the surface's curvature and may not grow with
  // the layers, the layers stay as high as those edges are long.
  double most_height(int i) const {
    const auto normal = [&](int k) { return draft_.mesh.data(draft_.front[k].vertex).normal; };
    double bend = 0.0;
    for (const int k : {draft_.front[i].prev, draft_.front[i].next}) {
      if (k >= 0) bend = std::max(bend, angle_between(normal(i), normal(k)));
    }
    const double most = kLongestOfEdge * draft_.shape(i).length();
    return bend > kCurved ? most : std::numeric_limits<double>::infinity();
  }

  void cap_by_gaps() {
    draft_.opposites = opposing_fronts(draft_.state, draft_.plan.shapes, draft_.heights);
    std::vector<int> crowded;
    for (int i = 0; i < draft_.front.size(); ++i) {
      if (!draft_.advances(i) || is_chain_end(draft_.front[i])) continue;
      const double height = draft_.height(i);
      if (!draft_.state.steps.sharing) continue;
      // Ours and the opposing one; a corner runs ahead of its row.
      const double rows = 1.0 + concave_factor(draft_.shape(i), height);
      draft_.heights[index(i)] = height_in_gap(height, draft_.opposites[index(i)].gap, rows);
      if (draft_.height(i) <= 0.0) crowded.push_back(i);
    }
    // The two corners at a strip's end do not see each other; they share its width likewise.
    for (int i = 0; i < draft_.front.size(); ++i) {
      const int k = draft_.front[i].next;
      if (!draft_.advances(i) || k < 0 || !draft_.is_strip_end(i, k)) continue;
      const double width = draft_.shape(i).length_next;
      for (const int end : {i, k}) {
        if (width < 2.0 * draft_.height(end)) crowded.push_back(end);
        draft_.heights[index(end)] = std::min(draft_.height(end), width / 3.0);
      }
    }
    for (const int i : crowded) {
      if (draft_.advances(i)) draft_.end(i, Stop::kCollision);
    }
    draft_.drop_lone_nodes(Stop::kCollision);
  }

  PlanDraft& draft_;
};

}  // namespace

void set_heights(PlanDraft& draft) { HeightSetter(draft).run(); }

}  // namespace advlayers
