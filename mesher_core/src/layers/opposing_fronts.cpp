#include "layers/opposing_fronts.h"

#include <algorithm>
#include <cmath>

#include "base/ties.h"
#include "layers/front_index.h"

namespace advlayers {
namespace {

constexpr double kCapReach = 3.0;    // heights
constexpr double kAlignReach = 2.5;  // front edges
constexpr double kMostSlide = 0.3;   // of the height: 17 degrees

class Aligner {
 public:
  Aligner(const LayerState& state, const std::vector<NodeShape>& shapes,
          const std::vector<double>& heights)
      : mesh_(state.mesh),
        front_(state.front),
        shapes_(shapes),
        heights_(heights),
        aligns_(state.steps.alignment && state.layer > kStraightLayers),
        opposites_(shapes.size()),
        sights_(shapes.size()) {}

  std::vector<Opposite> run() {
    look_ahead();
    if (aligns_) {
      for (int i = 0; i < front_.size(); ++i) find_partner(i);
      for (int i = 0; i < front_.size(); ++i) slide_to_partner(i);
      spread_slides();
    }
    return std::move(opposites_);
  }

 private:
  struct Sight {
    bool seen = false;
    FrontIndex::Hit hit;
    int partner = -1;
    double offset = 0.0;  // from where the vertex is heading to where its partner is [mm]
  };
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  void look_ahead() {
    const FrontIndex fronts(mesh_, front_);
    for (int i = 0; i < front_.size(); ++i) {
      if (!front_[i].active) continue;
      double reach = kCapReach * heights_[index(i)];
      if (aligns_) reach = std::max(reach, kAlignReach * shapes_[index(i)].length());
      Sight& sight = sights_[index(i)];
      sight.seen = fronts.nearest_ahead(i, shapes_[index(i)], reach, sight.hit);
      if (sight.seen) opposites_[index(i)].gap = sight.hit.distance;
    }
  }

  bool may_slide(int i) const {
    const FrontNode& node = front_[i];
    return node.active && node.prev >= 0 && node.next >= 0 && sights_[index(i)].seen &&
           std::abs(shapes_[index(i)].turn()) < kRegularTurn;
  }
  Vec3 along(int i) const {
    return (shapes_[index(i)].to_next - shapes_[index(i)].to_prev).normalized();
  }
  // Where the vertex is in the middle of the gap, if it goes straight on.
  Vec3 meeting_place(int i, double gap) const {
    return mesh_.position(front_[i].vertex) + 0.5 * gap * shapes_[index(i)].inward;
  }

  // The opposing vertex that i would meet with the least slide; in step with both its neighbours.
  void find_partner(int i) {
    Sight& sight = sights_[index(i)];
    if (!may_slide(i) || sight.hit.node < 0) return;
    const int a = sight.hit.node, b = front_[a].next;
    const Vec3 place = meeting_place(i, sight.hit.distance);
    for (const int k : {a, b, front_[a].prev, b < 0 ? -1 : front_[b].next}) {
      if (k < 0 || !front_[k].active || k == i) continue;
      const double offset = (meeting_place(k, sight.hit.distance) - place).dot(along(i));
      if (sight.partner >= 0 && settled(std::abs(offset)) >= settled(std::abs(sight.offset))) {
        continue;
      }
      sight.partner = k;
      sight.offset = offset;
    }
  }

  // Each of the two goes half the way, in as many rows as still fit.
  void slide_to_partner(int i) {
    const Sight& sight = sights_[index(i)];
    if (sight.partner < 0 || sights_[index(sight.partner)].partner != i) return;
    const double height = heights_[index(i)];
    const double rows = std::max(1.0, 0.5 * sight.hit.distance / height);
    opposites_[index(i)].slide =
        std::clamp(0.5 * sight.offset / rows, -kMostSlide * height, kMostSlide * height);
    aligned_.push_back(i);
  }

  // Vertices without a partner go with their neighbours.
  void spread_slides() {
    std::vector<char> has(opposites_.size(), 0);
    for (const int i : aligned_) has[index(i)] = 1;
    for (int i = 0; i < front_.size(); ++i) {
      if (has[index(i)] || !may_slide(i)) continue;
      const int p = front_[i].prev, n = front_[i].next;
      if (!has[index(p)] || !has[index(n)]) continue;
      opposites_[index(i)].slide = 0.5 * (opposites_[index(p)].slide + opposites_[index(n)].slide);
    }
  }

  const SurfaceMesh& mesh_;
  const Front& front_;
  const std::vector<NodeShape>& shapes_;
  const std::vector<double>& heights_;
  bool aligns_;
  std::vector<Opposite> opposites_;
  std::vector<Sight> sights_;
  std::vector<int> aligned_;
};

}  // namespace

std::vector<Opposite> opposing_fronts(const LayerState& state, const std::vector<NodeShape>& shapes,
                                      const std::vector<double>& heights) {
  return Aligner(state, shapes, heights).run();
}

}  // namespace advlayers
