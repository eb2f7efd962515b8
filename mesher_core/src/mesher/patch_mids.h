// The middle of every mesh edge of one finished patch, on the exact surface. Mesh edges along a
// curved border bend with it, layer by layer: in a thin layer a straight one would cut the border.
#pragma once

#include <memory>
#include <vector>

#include "base/run_context.h"
#include "mesher/boundary_mids.h"
#include "mesher/curved_element.h"
#include "mesher/patch_job.h"

namespace advlayers {

class PatchMids {
 public:
  // The job must be meshed, and stay as it is.
  PatchMids(const PatchJob& job, const Model& model, const Settings& settings,
            const BoundaryMids& boundary);

  // Places all of them. Throws Cancelled.
  void place(const RunContext& context);

  const PatchJob& job() const { return job_; }
  // Which of the border's mid nodes a mesh edge has; -1 where it has its own.
  int shared(HalfedgeH h) const { return mids_[h.index() >> 1].shared; }
  Vec3 at(HalfedgeH h) const;

  // Elements that are turned over, or nearly so, at one of their nodes.
  std::vector<FaceH> overbent(const RunContext& context) const;
  bool overbent(FaceH face) const;

  // Draws the mid node of an edge that is not shared back by one step, first within the surface,
  // then off it.
  static constexpr int kEasings = BoundaryMid::kEasings;
  void ease(HalfedgeH h);
  // The side of an overbent element that is best drawn back by a step: one whose mid node stays on
  // the CAD, if that helps at all. Invalid where all sides are straight.
  HalfedgeH best_to_ease(FaceH face) const;

  bool eased(HalfedgeH h) const { return mids_[h.index() >> 1].eased > 0; }
  double off_cad(HalfedgeH h) const;  // [mm] how far from it this mid node was drawn back

 private:
  struct Mid {
    Vec3 at = Vec3::Zero();
    double sagitta = 0.0;  // to the left of the even half-edge, within the surface [mm]
    int shared = -1;
    std::uint8_t eased = 0;  // kEasings on the CAD, as many off it
  };
  // An edge without a bend of its own has no steps on the CAD.
  static int next_step(const Mid& mid) {
    return mid.sagitta == 0.0 && mid.eased == 0 ? kEasings + 1 : mid.eased + 1;
  }
  Vec3 chord(HalfedgeH h) const;
  Vec3 leftwards(HalfedgeH h) const;
  bool foot(const Vec3& xyz, HalfedgeH h, SurfacePoint& found) const;
  Vec3 on_cad(HalfedgeH h, double share) const;
  Vec3 placed(HalfedgeH h, int eased) const;
  void bend_layers();
  CurvedElement element(FaceH face) const;

  const PatchJob& job_;
  const SurfaceMesh& mesh_;
  const BoundaryMids& boundary_;
  mutable Evaluator evaluator_;
  mutable PatchSurface surface_;
  std::vector<Mid> mids_;  // by edge
};

}  // namespace advlayers
