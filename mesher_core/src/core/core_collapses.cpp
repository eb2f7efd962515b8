#include "core/core_collapses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/ties.h"
#include "core/core_shape.h"
#include "measure/core_region.h"

namespace advlayers {
namespace {

constexpr double kPoorSine = 0.5;     // of 30 degrees
constexpr double kLeastGain = 1e-6;   // of the sine
constexpr double kLongestMade = 1.4;  // of the longest edge about the vertex
constexpr double kStraight = 0.9659;  // cosine of 15 degrees, that the edge of the CAD may turn
constexpr int kRounds = 4;            // a collapse may make room for another

class Collapser {
 public:
  Collapser(const RunContext& context, SurfaceMesh& mesh) : mesh_(mesh), context_(context) {}

  int run() {
    int total = 0;
    for (int round = 0; round < kRounds; ++round) {
      int collapsed = 0;
      for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
        context_.check();
        const FaceH f(i);
        if (is_poor(f) && collapse_side(f)) ++collapsed;
      }
      total += collapsed;
      if (collapsed == 0) break;
    }
    return total;
  }

 private:
  bool is_poor(FaceH f) const {
    if (!mesh_.alive(f) || !is_core(mesh_, f)) return false;
    const HalfedgeH h = mesh_.halfedge(f);
    if (!mesh_.is_triangle(h)) return false;
    return shape_of(mesh_, mesh_.from(h), mesh_.to(h), mesh_.to(mesh_.next(h))).sine < kPoorSine;
  }

  double length(HalfedgeH h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }

  bool collapse_side(FaceH f) {
    HalfedgeH shortest = mesh_.halfedge(f);
    for (const HalfedgeH h : {mesh_.next(shortest), mesh_.prev(shortest)}) {
      if (settled(length(h)) < settled(length(shortest))) shortest = h;
    }
    const HalfedgeH back = SurfaceMesh::twin(shortest);
    const double there = gain(shortest), back_gain = gain(back);
    if (std::max(there, back_gain) < kLeastGain) return false;
    const HalfedgeH h = settled(there) >= settled(back_gain) ? shortest : back;
    mesh_.set_frozen(h, false);
    mesh_.collapse(h);
    return true;
  }

  // Of the least sine about the vertex that would vanish; negative where it has to stay.
  double gain(HalfedgeH h) {
    if (!may_move(h)) return -1.0;
    const bool frozen = mesh_.frozen(h);
    mesh_.set_frozen(h, false);
    const Veto veto = mesh_.collapse_veto(h);
    mesh_.set_frozen(h, frozen);
    if (veto != Veto::kNone) return -1.0;
    const VertexH onto = mesh_.to(h);
    CoreShape before{1.0, 1.0}, after{1.0, 1.0};
    double longest = 0.0, longest_made = 0.0;
    for (const HalfedgeH o : mesh_.around(h)) {
      const VertexH a = mesh_.to(o), b = mesh_.to(mesh_.next(o));
      add(shape_of(mesh_, mesh_.from(h), a, b), before);
      if (a != onto && b != onto) add(shape_of(mesh_, onto, a, b), after);
      longest = std::max(longest, length(o));
      longest_made = std::max(longest_made, (mesh_.position(a) - mesh_.position(onto)).norm());
    }
    if (longest_made > kLongestMade * longest) return -1.0;
    if (after.lean < std::min(kLeastLeanCosine, before.lean)) return -1.0;
    return after.sine - before.sine;
  }

  static void add(const CoreShape& one, CoreShape& worst) {
    worst.sine = std::min(worst.sine, one.sine);
    worst.lean = std::min(worst.lean, one.lean);
  }

  // A vertex among core triangles, on no frozen edge, or between two that go on straight along
  // the same edge of the CAD, of which h is one.
  bool may_move(HalfedgeH h) const {
    const VertexH v = mesh_.from(h);
    const VertexData& data = mesh_.data(v);
    if (data.support == Support::kVertex || data.node.valid() || data.layer != 0) return false;
    int frozen = 0;
    HalfedgeH along;
    for (const HalfedgeH o : mesh_.around(h)) {
      if (mesh_.is_border(o) || !is_core(mesh_, mesh_.face(o)) || !mesh_.is_triangle(o)) {
        return false;
      }
      if (mesh_.frozen(o)) {
        ++frozen;
        if (o != h) along = o;
      }
    }
    if (frozen == 0) return data.support == Support::kPatch;
    if (frozen != 2 || !mesh_.frozen(h) || mesh_.curve(along) != mesh_.curve(h)) return false;
    const Vec3 before = mesh_.position(v) - mesh_.position(mesh_.to(along));
    const Vec3 after = mesh_.position(mesh_.to(h)) - mesh_.position(v);
    return before.dot(after) > kStraight * before.norm() * after.norm();
  }

  SurfaceMesh& mesh_;
  const RunContext& context_;
};

}  // namespace

int collapse_slivers(const RunContext& context, SurfaceMesh& mesh) {
  return Collapser(context, mesh).run();
}

}  // namespace advlayers
