// Where the nodes of an existing mesh lie on the model, and how dense they are.
#pragma once

#include <vector>

#include "base/point_tree.h"
#include "base/run_context.h"
#include "geometry/model.h"
#include "sizing/initial_mesh.h"

namespace advlayers {

class InitialNodes {
 public:
  // Puts each node of a triangle onto the face that is nearest to it. `faces`: those to be meshed.
  // Throws InvalidInput where the mesh is none of the shape, or not whole: an index out of range, a
  // coordinate that is not finite, no triangle, a node further off the shape than a quarter of its
  // spacing, a face of `faces` with a part that no triangle is near to. Throws Cancelled.
  InitialNodes(const RunContext& context, const Model& model, const InitialMesh& mesh,
               const std::vector<FaceId>& faces);

  // On the face; those on its border are on one of the faces beside it.
  const std::vector<SurfacePoint>& on(FaceId face) const { return on_face_[face.index()].nodes; }
  // The median length of the mesh edges about the nearest node on the face, averaged with its
  // neighbours' [mm]; infinite where the face has no node.
  double spacing(FaceId face, const Vec3& p) const;

  // Nodes that lay off the shape, by more than a thousandth of their spacing, and the most [mm].
  int moved() const { return moved_; }
  double farthest() const { return farthest_; }

 private:
  struct OnFace {
    std::vector<SurfacePoint> nodes;
    std::vector<double> spacings;
    PointTree tree;
  };
  std::vector<OnFace> on_face_;
  int moved_ = 0;
  double farthest_ = 0.0;
};

}  // namespace advlayers
