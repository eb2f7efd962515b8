// The edge length asked for at a place, before curvature: of all, of faces and edges of their own,
// about points of refinement, and where an
// initial mesh is finer.
#pragma once

#include <unordered_map>
#include <vector>

#include "sizing/settings.h"

namespace advlayers {

class SizeField {
 public:
  explicit SizeField(const Settings& settings);

  double of_face(FaceId face) const;  // [mm]
  // That of the edge itself, or the least of the faces beside it [mm].
  double of_edge(EdgeId edge, const std::vector<FaceId>& beside) const;
  // What an edge of its own asks for, or none.
  const SizeSpec* edge_spec(EdgeId edge) const;
  // `size`, or less near a point of refinement or where the initial mesh on the face is clearly
  // finer [mm].
  double near(const Vec3& p, FaceId face, double size) const;
  // Change of the size per length [1]: neighbours differ by no more than `size_growth`.
  double slope() const { return slope_; }
  bool refined() const { return !refinements_.empty() || initial_ != nullptr; }

 private:
  double size_;
  double slope_;
  std::vector<Refinement> refinements_;
  std::shared_ptr<const InitialNodes> initial_;
  std::unordered_map<FaceId, double> faces_;
  std::unordered_map<EdgeId, SizeSpec> edges_;
};

}  // namespace advlayers
