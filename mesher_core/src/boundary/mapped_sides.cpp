#include "boundary/mapped_sides.h"

#include <algorithm>
#include <set>

namespace advlayers {
namespace {

constexpr int kMostRounds = 200;  // over chains of faces that share sides

class SideBalance {
 public:
  explicit SideBalance(Stretches& stretches) : stretches_(stretches) {}

  // Returns whether one of the two took more.
  bool run(const std::vector<CoEdge>& a, const std::vector<CoEdge>& b) {
    const int missing = count_on(a) - count_on(b);
    for (int k = 0; k < std::abs(missing); ++k) {
      if (!part_longest(missing < 0 ? a : b)) return false;
    }
    return missing != 0;
  }

 private:
  std::set<std::size_t> on(const std::vector<CoEdge>& side) const {
    std::set<std::size_t> found;
    for (const CoEdge& coedge : side) {
      found.insert(stretches_.of(coedge.edge).begin(), stretches_.of(coedge.edge).end());
    }
    return found;
  }
  int count_on(const std::vector<CoEdge>& side) const {
    int count = 0;
    for (const std::size_t i : on(side)) count += stretches_[i].spacing.count();
    return count;
  }
  bool part_longest(const std::vector<CoEdge>& side) {
    EdgeSpacing* longest = nullptr;
    for (const std::size_t i : on(side)) {
      EdgeSpacing& spacing = stretches_[i].spacing;
      if (!spacing.can_lengthen()) continue;
      if (longest == nullptr || spacing.mean_free_segment() > longest->mean_free_segment()) {
        longest = &spacing;
      }
    }
    if (longest != nullptr) longest->lengthen();
    return longest != nullptr;
  }

  Stretches& stretches_;
};

}  // namespace

void even_out_sides(const RunContext& context, const std::vector<FourSides>& mapped,
                    Stretches& stretches) {
  SideBalance balance(stretches);
  bool changed = !mapped.empty();
  for (int round = 0; changed && round < kMostRounds; ++round) {
    context.check();
    changed = false;
    for (const FourSides& face : mapped) {
      changed = balance.run(face.sides[0], face.sides[2]) || changed;
      changed = balance.run(face.sides[1], face.sides[3]) || changed;
    }
  }
}

}  // namespace advlayers
