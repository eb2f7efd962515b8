// The local operations of the improvement in space, each guarded by triangle_score.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"
#include "triangulate/triangle_score.h"

namespace advlayers {

class SurfaceOps {
 public:
  // `sizes`: the wanted edge length [mm] by vertex; grows with the mesh.
  SurfaceOps(SurfaceMesh& mesh, std::vector<double>& sizes, PatchSurface& surface);

  const SurfaceMesh& mesh() const { return mesh_; }
  bool movable(VertexH v) const { return mesh_.data(v).support == Support::kPatch; }
  double score(FaceH f) const;
  double standing_about(VertexH v) const;
  double wanted_length(HalfedgeH h) const {
    return (sizes_[mesh_.from(h).index()] + sizes_[mesh_.to(h).index()]) / 2;
  }
  double length(HalfedgeH h) const {
    return (mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h))).norm();
  }

  // Flips h if that makes the worse of its two triangles better.
  bool flip(HalfedgeH h);
  // Moves v towards `target`, along the surface, if the worst triangle about it gets better or
  // stays above `enough`.
  bool move(VertexH v, const Vec3& target, double enough);
  // Moves a free vertex to the best of some positions about it that make its worst triangle better.
  bool optimize(VertexH v);
  // Removes from(h) if the triangles that come of it are better than the worst before, or above
  // `enough`, and no edge longer than the wanted length allows.
  bool collapse(HalfedgeH h, double enough);
  // Divides h at its middle on the surface if the parts are better than the worst before, or above
  // `enough`. The new vertex is moved to a better place, if there is one.
  bool split(HalfedgeH h, double enough);

  // The mean of the neighbours.
  Vec3 center_of_neighbours(VertexH v) const;

 private:
  Corner corner_at(VertexH v) const;
  double standing_with(VertexH v, const Corner& moved) const;
  bool place(VertexH v, const Vec3& target, SurfacePoint& foot, Corner& at);
  Vec3 ideal_apex(VertexH a, VertexH b, VertexH v) const;

  SurfaceMesh& mesh_;
  std::vector<double>& sizes_;
  PatchSurface& surface_;
};

}  // namespace advlayers
