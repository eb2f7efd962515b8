#include "triangulate/improve_surface.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/ties.h"
#include "triangulate/surface_ops.h"

namespace advlayers {
namespace {

// Moves that leave all angles above this need no gain.
const double kGoodScore = score_of_angle(38 * kDegree);
// Triangles below this are mended one by one.
const double kPoorScore = score_of_angle(30 * kDegree);
const double kFairScore = score_of_angle(22 * kDegree);
constexpr double kTooLong = 1.5, kTooShort = 0.6;  // in wanted lengths
constexpr int kSmoothingRounds = 2;                // before and after lengths are mended
constexpr int kMendingRounds = 6;                  // of flips, splits and collapses

class Improver {
 public:
  Improver(const RunContext& context, GluedMesh& glued, PatchSurface& surface)
      : mesh_(glued.mesh), ops_(glued.mesh, glued.sizes, surface), context_(context) {}

  void run(Places places) {
    const int smoothing_rounds = places == Places::kEvened ? kSmoothingRounds : 0;
    flip_all();
    for (int i = 0; i < smoothing_rounds; ++i) smooth_and_flip();
    mend_lengths();
    flip_all();
    for (int i = 0; i < smoothing_rounds; ++i) smooth_and_flip();
    for (int i = 0; i < kMendingRounds && mend_poor_triangles(); ++i) flip_all();
  }

 private:
  template <class Act>
  void for_each_halfedge(Act&& act) {
    for (std::size_t i = 0; i < mesh_.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (mesh_.alive(h) && !mesh_.frozen(h)) act(h);
    }
  }

  void flip_all() {
    std::vector<HalfedgeH> pending;
    for_each_halfedge([&](HalfedgeH h) { pending.push_back(h); });
    while (!pending.empty()) {
      const HalfedgeH h = pending.back();
      pending.pop_back();
      context_.check();
      if (mesh_.frozen(h) || !ops_.flip(h)) continue;
      const HalfedgeH t = SurfaceMesh::twin(h);
      pending.insert(pending.end(), {mesh_.next(h), mesh_.prev(h), mesh_.next(t), mesh_.prev(t)});
    }
  }

  void smooth_and_flip() {
    for (std::size_t i = 0; i < mesh_.vertex_capacity(); ++i) {
      const VertexH v(i);
      if (!mesh_.alive(v) || !ops_.movable(v)) continue;
      context_.check();
      ops_.move(v, ops_.center_of_neighbours(v), kGoodScore);
    }
    flip_all();
  }

  void mend_lengths() {
    for_each_halfedge([&](HalfedgeH h) {
      context_.check();
      const double relative = ops_.length(h) / ops_.wanted_length(h);
      if (relative > kTooLong) {
        ops_.split(h, kFairScore);
      } else if (relative < kTooShort && !ops_.collapse(h, kPoorScore)) {
        ops_.collapse(SurfaceMesh::twin(h), kPoorScore);
      }
    });
  }

  // Tries the operations on every triangle that is not good yet. False: nothing was changed.
  bool mend_poor_triangles() {
    bool changed = false;
    for (std::size_t i = 0; i < mesh_.face_capacity(); ++i) {
      const FaceH f(i);
      context_.check();
      if (!mesh_.alive(f) || ops_.score(f) >= kPoorScore) continue;
      if (mend(f)) changed = true;
    }
    return changed;
  }

  bool mend(FaceH f) {
    std::array<HalfedgeH, 3> sides;
    sides[0] = mesh_.halfedge(f);
    sides[1] = mesh_.next(sides[0]);
    sides[2] = mesh_.next(sides[1]);
    std::sort(sides.begin(), sides.end(), [this](HalfedgeH a, HalfedgeH b) {
      const double la = settled(ops_.length(a)), lb = settled(ops_.length(b));
      return la != lb ? la < lb : a < b;
    });
    for (const HalfedgeH h : sides) {
      if (!mesh_.frozen(h) && ops_.flip(h)) return true;
    }
    for (const HalfedgeH h : sides) {
      if (ops_.optimize(mesh_.from(h))) return true;
    }
    for (const HalfedgeH h : sides) {
      if (mesh_.frozen(h)) continue;
      if (ops_.collapse(h, kPoorScore) || ops_.collapse(SurfaceMesh::twin(h), kPoorScore)) {
        return true;
      }
    }
    return !mesh_.frozen(sides[2]) && ops_.split(sides[2], kPoorScore);
  }

  SurfaceMesh& mesh_;
  SurfaceOps ops_;
  const RunContext& context_;
};

}  // namespace

void improve_surface(const RunContext& context, GluedMesh& glued, PatchSurface& surface,
                     Places places) {
  Improver(context, glued, surface).run(places);
}

}  // namespace advlayers
