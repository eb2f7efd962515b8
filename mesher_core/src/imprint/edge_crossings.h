// Where mesh edges cross the model's edges inside a patch.
#pragma once

#include <vector>

#include "geometry/patch_surface.h"
#include "imprint/face_sides.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

struct CutPoint {
  double share = 0.0;         // along the mesh edge
  SurfacePoint point;         // on the model's edge
  std::vector<FaceId> faces;  // beside it, sorted
};

class EdgeCrossings {
 public:
  EdgeCrossings(const SurfaceMesh& mesh, PatchSurface& surface, const FaceSides& sides)
      : mesh_(mesh), surface_(surface), sides_(sides) {}

  // All crossings of the mesh edge a -> b in order; empty where there are none, or they cannot be
  // told.
  std::vector<CutPoint> between(VertexH a, VertexH b);

 private:
  using Faces = std::vector<FaceId>;
  bool find_cut(const Vec3& a, const Vec3& b, FaceId from, FaceId onto, double off, CutPoint& cut);
  bool nearest_cut(const Vec3& a, const Faces& faces_a, const Vec3& b, const Faces& faces_b,
                   double most_off, CutPoint& best);
  std::vector<CutPoint> cuts_over_third(const Vec3& a, const Faces& faces_a, const Vec3& b,
                                        const Faces& faces_b);
  bool collect(const SurfacePoint& a, const Faces& faces_a, double share_a, const SurfacePoint& b,
               const Faces& faces_b, double share_b, int depth, std::vector<CutPoint>& cuts);

  const SurfaceMesh& mesh_;
  PatchSurface& surface_;
  const FaceSides& sides_;
};

}  // namespace advlayers
