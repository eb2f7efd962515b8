#include "layers/thin_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/angles.h"
#include "base/ties.h"

namespace advlayers {
namespace {

constexpr double kCollapseLength = 2.0 * 0.41421356237309503;  // 2 tan(pi / 8), paper II.F
// Three front edges become one where their kids' edges are on average shorter than this many
// heights.
constexpr double kCoarsenLength = 0.95;
constexpr double kCoarsenLongest = 1.2;
constexpr double kCoarsenTurn = 25.0 * kDegree;
// An edge that turns further than this with the surface is not made by thinning: the mesh would cut
// through what the front runs around. Only edges that have nearly vanished are merged all the same.
constexpr double kBentEdge = 0.8660254037844387;  // cosine of 30 degrees
constexpr double kVanishingLength = 0.25;         // in heights
constexpr double kTreadHeight = 0.42;  // of the inner kids, in heights: evens the angles out
// While heights matter most, edges are thinned only where the front itself drives the kids
// together: where these lie nearer to each other than this share of their parents' distance, as
// beside a concave corner. An edge that was short from the wall on keeps its column, and the row
// its height.
constexpr double kDrivenTogether = 0.5;

class Coarsener {
 public:
  explicit Coarsener(PlanDraft& draft) : draft_(draft) {}

  void run() {
    if (draft_.state.layer <= kStraightLayers) return;
    for (int i = 0; i < draft_.front.size(); ++i) try_coarsen(i);
  }

 private:
  static std::size_t index(int i) { return PlanDraft::index(i); }

  //   k ---------------- m      Three short front edges become one, with quads alone: the inner two
  //   | \              / |      kids stay low, and the outer two are joined over them. It costs no
  //   |   x -------- y   |      triangle where two collapses cost two.
  //   |   |          |   |
  //   a - b -------- c - d
  bool try_coarsen(int a) {
    const int b = draft_.front[a].next;
    const int c = b < 0 ? -1 : draft_.front[b].next;
    const int d = c < 0 ? -1 : draft_.front[c].next;
    if (d < 0 || d == a || draft_.front[d].next == a) return false;
    const std::array<int, 4> nodes{a, b, c, d};
    double height = 0.0;
    for (const int i : nodes) {
      if (!has_plain_kid(i)) return false;
      height += 0.25 * draft_.height(i);
    }
    if (std::abs(draft_.shape(b).turn()) > kCoarsenTurn ||
        std::abs(draft_.shape(c).turn()) > kCoarsenTurn) {
      return false;
    }
    double length = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double edge = kid_distance(plain_kid(nodes[index(k)]), plain_kid(nodes[index(k + 1)]));
      if (edge > kCoarsenLongest * height) return false;
      length += edge / 3.0;
    }
    if (length > kCoarsenLength * height || bent(plain_kid(a), plain_kid(d))) return false;
    return lower_treads(a, b, c, d);
  }
  bool has_plain_kid(int i) const {
    const auto& kids = draft_.kids_of(i);
    if (kids.size() != 1 || draft_.kid(kids[0]).tread) return false;
    const Kid& kid = draft_.kid(kids[0]);
    return kid.parents.size() == 1 && kid.fan_age < 0;
  }
  double kid_distance(int p, int q) const {
    return (draft_.kid(p).point.xyz - draft_.kid(q).point.xyz).norm();
  }
  int plain_kid(int i) const { return draft_.kids_of(i)[0]; }
  bool bent(int p, int q) const {
    return draft_.kid(p).normal.dot(draft_.kid(q).normal) < kBentEdge;
  }

  bool lower_treads(int a, int b, int c, int d) {
    const int k = plain_kid(a), x = plain_kid(b), y = plain_kid(c), m = plain_kid(d);
    const SurfacePoint old_x = draft_.kid(x).point, old_y = draft_.kid(y).point;
    const auto place = [&](int kid, int node) {
      SurfacePoint to;
      const double length = kTreadHeight * draft_.height(node);
      const SurfacePoint& from = draft_.mesh.data(draft_.front[node].vertex).point;
      if (!draft_.state.surface.step(from, draft_.shape(node).inward, length, to)) return false;
      draft_.kid(kid).point = to;
      draft_.kid(kid).normal = draft_.state.surface.normal(to);
      return true;
    };
    Cell top{{at_kid(x), at_kid(y), at_kid(m), at_kid(k)}, {{k, m}}, false};
    if (!place(x, b) || !place(y, c) || !draft_.convex(top) ||
        !draft_.convex({{at_node(a), at_node(b), at_kid(x), at_kid(k)}, {}}) ||
        !draft_.convex({{at_node(c), at_node(d), at_kid(m), at_kid(y)}, {}})) {
      draft_.kid(x).point = old_x;
      draft_.kid(y).point = old_y;
      return false;
    }
    draft_.kid(x).tread = draft_.kid(y).tread = true;
    draft_.tops.push_back(std::move(top));
    draft_.state.note_stop(b, Stop::kMerged);
    draft_.state.note_stop(c, Stop::kMerged);
    draft_.state.count_event(Event::kCoarsen);
    return true;
  }

  PlanDraft& draft_;
};

class Merger {
 public:
  explicit Merger(PlanDraft& draft) : draft_(draft) {}

  void run() {
    struct Pair {
      double length;
      int node;
    };
    std::vector<Pair> pairs;
    for (int i = 0; i < draft_.front.size(); ++i) {
      const int k = draft_.front[i].next;
      if (k < 0 || draft_.kids_of(i).empty() || draft_.kids_of(k).empty()) continue;
      const int p = draft_.kids_of(i).back(), q = draft_.kids_of(k).front();
      if (p == q) continue;
      const Vec3 along = draft_.kid(q).point.xyz - draft_.kid(p).point.xyz;
      const double forward = along.dot((draft_.position(k) - draft_.position(i)).normalized());
      const double height = 0.5 * (draft_.height(i) + draft_.height(k));
      const bool fan = draft_.kid(p).fan_age >= 0 && draft_.kid(q).fan_age >= 0;
      double limit = fan || draft_.is_strip_end(i, k) ? 0.2 : kCollapseLength;
      const double apart = (draft_.position(k) - draft_.position(i)).norm();
      const bool early = draft_.state.layer <= kStraightLayers;
      if ((early && forward > kDrivenTogether * apart) || bent_by_merging(i, k)) {
        limit = std::min(limit, kVanishingLength);
      }
      if (forward < limit * height) pairs.push_back({settled(forward), i});
    }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
      return a.length != b.length ? a.length < b.length : a.node < b.node;
    });
    for (const Pair& pair : pairs) merge(pair.node, draft_.front[pair.node].next);
  }

 private:
  // The merged kid will lie between two kids further along on either side.
  bool bent_by_merging(int i, int k) const {
    const int before = draft_.front[i].prev, after = draft_.front[k].next;
    const Vec3 merged =
        (draft_.kid(draft_.kids_of(i).back()).normal + draft_.kid(draft_.kids_of(k).front()).normal)
            .normalized();
    const auto bent = [&](int node, bool last) {
      if (node < 0 || draft_.kids_of(node).empty()) return false;
      const auto& kids = draft_.kids_of(node);
      return draft_.kid(last ? kids.back() : kids.front()).normal.dot(merged) < kBentEdge;
    };
    return bent(before, true) || bent(after, false);
  }

  // Of two merged kids the later node's stays, so that of two merged pairs side by side the quad
  // between them has a parent-kid edge; but the earlier one's where the node before shares a kid
  // that was extruded elsewhere, and a vertex of the boundary in any case.
  bool keeps_earlier(int i) const {
    const auto& kids = draft_.kids_of(i);
    if (kids.size() == 1 && draft_.kid(kids[0]).given) return true;
    const int before = draft_.front[i].prev;
    if (before < 0 || draft_.kids_of(before).empty()) return false;
    return draft_.kid(draft_.kids_of(before).back()).origin != before;
  }

  void merge(int i, int k) {
    if (!keeps_earlier(i)) std::swap(i, k);
    auto& kids_i = draft_.kids_of(i);
    auto& kids_k = draft_.kids_of(k);
    if (kids_i.size() != 1 || kids_k.size() != 1 || draft_.kid(kids_i[0]).tread ||
        draft_.kid(kids_k[0]).tread)
      return;
    Kid& kept = draft_.kid(kids_i[0]);
    Kid& gone = draft_.kid(kids_k[0]);
    if (kept.parents.size() != 1 || gone.parents.size() != 1 || gone.given) return;
    if (!kept.given) {
      SurfacePoint mean;
      if (!draft_.state.surface.project(0.5 * (kept.point.xyz + gone.point.xyz), kept.point,
                                        mean)) {
        return;
      }
      kept.point = mean;
      kept.normal = draft_.state.surface.normal(mean);
    }
    kept.parents.push_back(k);
    kept.growth = kept.growth.met_by(gone.growth);
    gone.alive = false;
    kids_k = kids_i;
    draft_.state.note_stop(k, Stop::kMerged);
    draft_.state.count_event(Event::kCollapse);
  }

  PlanDraft& draft_;
};

}  // namespace

void coarsen_front(PlanDraft& draft) { Coarsener(draft).run(); }
void merge_close_kids(PlanDraft& draft) { Merger(draft).run(); }

}  // namespace advlayers
