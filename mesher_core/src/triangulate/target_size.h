// The edge length wanted at a point of the surface, before any gradation.
#pragma once

#include "geometry/evaluator.h"
#include "sizing/size_field.h"

namespace advlayers {

// What a triangulation is for: a mesh to keep, or a surface for layers to grow on, of which nothing
// is left in the end.
enum class Density : std::uint8_t { kAsked, kCoarse };

class TargetSize {
 public:
  TargetSize(Evaluator& evaluator, const Settings& settings, Density density = Density::kAsked);

  // min(size, chord that turns by curvature_angle, or lies as far off as it may, at the largest
  // curvature) [mm], where the mesh is coarse for the sake of curvature alone; never less than
  // min_size and a fixed share of `extent`, so that tips and creases of no radius do not ask for
  // endless refinement.
  double at(const SurfacePoint& p);

  // What curvature alone never asks less than on the face [mm].
  double least(FaceId face) const;

  // Whether it is less about points of refinement, or by an initial mesh.
  bool refined() const { return sizes_.refined(); }

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
  Density density_;
};

}  // namespace advlayers
