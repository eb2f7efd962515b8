#include "layers/extrude_front.h"

#include <algorithm>
#include <cmath>

#include "layers/chain_end.h"
#include "layers/concave_scaling.h"

namespace advlayers {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kFanAngle = 247.5 * kDegree;       // from here three quads meet at the corner
constexpr double kReversalAngle = 315.0 * kDegree;  // and from here four

class Extruder {
 public:
  explicit Extruder(PlanDraft& draft) : draft_(draft) {}

  void run() {
    for (int i = 0; i < draft_.front.size(); ++i) {
      draft_.state.cancel->check();
      if (draft_.advances(i) && draft_.kids_of(i).empty()) extrude(i);
    }
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
    if (draft_.state.steps.fans && on_wall && s.angle >= kFanAngle) {
      extrude_fan(i, s.angle >= kReversalAngle ? 2 : 1);
      return;
    }
    const double height = draft_.height(i);
    const Vec3 along = (s.to_next - s.to_prev).normalized();
    const Vec3 way =
        concave_factor(s, height) * height * s.inward + draft_.opposites[index(i)].slide * along;
    if (draft_.step_kid(i, way.normalized(), way.norm()) < 0) draft_.end(i, Stop::kBlocked);
  }

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
