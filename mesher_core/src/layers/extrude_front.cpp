#include "layers/extrude_front.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/directions.h"
#include "layers/chain_end.h"
#include "layers/concave_scaling.h"

namespace advlayers {
namespace {

// An extrusion turns with the surface no further than elements may deviate from it (paper, II.D).
constexpr double kMostBend = 30.0 * kDegree;
constexpr double kMostEdgeBend = 50.0 * kDegree;  // of a front edge that spreads
constexpr double kEvening = 0.25;                 // of the edges' difference, per layer
constexpr double kEvenSlide = 0.15;               // of the height at most

class Extruder {
 public:
  explicit Extruder(PlanDraft& draft) : draft_(draft) {}

  void run() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      draft_.state.context.check();
      if (draft_.advances(i) && draft_.kids_of(i).empty()) extrude(i);
    }
    stop_bent_edges();
  }

  void step_ends() {
    const ChainEnds ends(draft_.state);
    for (int i = 0; i < draft_.front.size(); ++i) {
      if (!is_chain_end(draft_.front[i])) continue;
      const int inner = std::max(draft_.front[i].prev, draft_.front[i].next);
      const bool follows = !is_chain_end(draft_.front[inner]);
      if (follows && draft_.advances(inner)) {
        draft_.heights[index(i)] = std::min(draft_.height(i), draft_.height(inner));
      }
      const EndStep step = ends.step(i, draft_.height(i), follows);
      if (!step.kid.valid()) {
        // Fingers of layers would grow on from fans, whose edges grow as fast as their heights.
        const bool flat = draft_.shape(i).length() > kStepAspect * draft_.height(i);
        if (flat || draft_.state.stop_at_isotropy) draft_.end(i, Stop::kNeighbour);
      } else if (step.height <= 0.0) {
        draft_.end(i, Stop::kCollision);
      } else {
        add_given_kid(i, step);
      }
    }
    draft_.drop_lone_nodes(Stop::kNeighbour);
  }

 private:
  static std::size_t index(int i) { return PlanDraft::index(i); }

  void add_given_kid(int i, const EndStep& step) {
    Kid& kid = draft_.kid(draft_.add_kid(i, draft_.mesh.data(step.kid).point));
    kid.vertex = step.kid;
    kid.given = true;
    kid.lag = step.lag;
    if (step.kid == draft_.front[i].vertex) kid.parents.clear();
  }

  void extrude(int i) {
    const NodeShape& s = draft_.shape(i);
    const bool on_wall = draft_.mesh.data(draft_.front[i].vertex).support != Support::kPatch;
    const CornerClass corner = corner_class(s.angle);
    if (draft_.state.steps.fans && on_wall && corner >= CornerClass::kCorner) {
      extrude_fan(i, corner == CornerClass::kReversal ? 2 : 1);
      return;
    }
    const double height = draft_.height(i);
    const Vec3 along = (s.to_next - s.to_prev).normalized();
    const double slide = draft_.opposites[index(i)].slide + evening_slide(i);
    const Vec3 way = concave_factor(s, height) * height * s.inward + slide * along;
    if (!step_unbent(i, way.normalized(), way.norm())) draft_.end(i, Stop::kBlocked);
  }

  // Towards the longer of the two edges, where the surface drives columns together or apart: on
  // the bend of a pipe they would leave one side.
  double evening_slide(int i) const {
    if (draft_.state.layer <= kStraightLayers) return 0.0;
    for (const int k : {draft_.front[i].prev, i, draft_.front[i].next}) {
      if (k < 0 || !draft_.advances(k) || std::abs(draft_.shape(k).turn()) > kRegularTurn)
        return 0.0;
    }
    const NodeShape& s = draft_.shape(i);
    const double most = kEvenSlide * draft_.height(i);
    return std::clamp(kEvening * (s.length_next - s.length_prev), -most, most);
  }

  // A kid no farther than the surface turns by kMostBend: the layer stays below what was asked for
  // where the surface is curved more tightly.
  bool step_unbent(int i, const Vec3& direction, double length) {
    const int kid = draft_.step_kid(i, direction, length);
    if (kid < 0) return false;
    const double bend = angle_between(normal(i), draft_.kid(kid).normal);
    if (bend <= kMostBend) return true;
    draft_.drop_kids_of(i);
    draft_.heights[index(i)] *= kMostBend / bend;
    return draft_.step_kid(i, direction, length * kMostBend / bend) >= 0;
  }

  // Columns that spread on a curved surface would leave it between them: both stop where the edge
  // of their kids turns too far with it, and the core goes on with edges of its own size.
  void stop_bent_edges() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      const int k = draft_.front[i].next;
      if (k < 0 || draft_.kids_of(i).empty() || draft_.kids_of(k).empty()) continue;
      const Kid &p = draft_.kid(draft_.kids_of(i).back()),
                &q = draft_.kid(draft_.kids_of(k).front());
      const double bend = angle_between(p.normal, q.normal);
      if (bend <= kMostEdgeBend || bend <= angle_between(normal(i), normal(k))) continue;
      for (const int node : {i, k}) {
        if (draft_.advances(node)) draft_.end(node, Stop::kBent);
      }
    }
    draft_.drop_lone_nodes(Stop::kBent);
  }
  const Vec3& normal(int i) const { return draft_.mesh.data(draft_.front[i].vertex).normal; }

  // Several kids at a convex corner: the perpendiculars of both edges, and between each two of
  // `quads` + 1 spokes a diagonal kid at h / cos of half the sector.
  void extrude_fan(int i, int quads) {
    const NodeShape& s = draft_.shape(i);
    const double height = draft_.height(i);
    const double sector = (s.angle - M_PI) / quads;
    const Vec3 first = rotated(s.to_prev, s.normal, -0.5 * M_PI);
    for (int k = 0; k <= 2 * quads; ++k) {
      const bool diagonal = k % 2 == 1;
      const double length = diagonal ? height / std::max(0.4, std::cos(0.5 * sector)) : height;
      const int kid = draft_.step_kid(i, rotated(first, s.normal, -0.5 * k * sector), length);
      if (kid < 0) {
        draft_.end(i, Stop::kBlocked);
        return;
      }
      draft_.kid(kid).fan_age = 0;
      if (diagonal) draft_.kid(kid).parents.clear();
    }
    draft_.state.count_event(Event::kFan);
  }

  PlanDraft& draft_;
};

}  // namespace

void step_chain_ends(PlanDraft& draft) { Extruder(draft).step_ends(); }
void extrude_front(PlanDraft& draft) { Extruder(draft).run(); }

}  // namespace advlayers
