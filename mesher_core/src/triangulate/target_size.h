// The edge length wanted at a point of the surface, before any gradation.
#pragma once

#include "geometry/evaluator.h"
#include "sizing/size_field.h"

namespace advlayers {

class TargetSize {
 public:
  TargetSize(Evaluator& evaluator, const Settings& settings);

  // min(size, chord that turns by curvature_angle, or lies as far off as it may, at the largest
  // curvature) [mm]; never less than min_size and a fixed share of `extent`, so that tips and
  // creases of no radius do not ask for endless refinement.
  double at(const SurfacePoint& p);

  // What curvature alone never asks less than on the face [mm].
  double least(FaceId face) const;

  // Change of the wanted length per length [1].
  double gradation() const { return sizes_.slope(); }

  // The size, or the square root of the face's area if that is less [mm].
  double extent(FaceId face) const;

 private:
  Evaluator* evaluator_;
  SizeField sizes_;
  double chord_of_unit_radius_;
  double chord_deviation_;  // [mm] 0: any
  double min_size_;         // [mm]
};

}  // namespace advlayers
