// Which CAD faces of a patch each mesh vertex lies on: one, or all that meet at the edge or vertex
// of the model under it.
#pragma once

#include <vector>

#include "boundary/discretization.h"
#include "geometry/patch_surface.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

class FaceSides {
 public:
  FaceSides(const SurfaceMesh& mesh, const PatchSurface& surface, const Discretization& boundary);

  const std::vector<FaceId>& of(VertexH v) const { return sides_[v.index()]; }
  void put(VertexH v, std::vector<FaceId> faces);  // sorted
  bool share_face(VertexH a, VertexH b) const;
  // The faces that all of the vertices lie on, and the first of them, invalid where there is none.
  std::vector<FaceId> all_common(const std::vector<VertexH>& vertices) const;
  FaceId common(const std::vector<VertexH>& vertices) const;
  // The face that the element with these corners lies on: where they are all on one edge of the
  // model, the side that its middle is on. Invalid where there is none.
  FaceId under(const SurfaceMesh& mesh, PatchSurface& surface,
               const std::vector<VertexH>& corners) const;
  // Of the patch, at a vertex of the model; sorted.
  std::vector<FaceId> at(VertexId vertex) const;

 private:
  void put_by_curves(const SurfaceMesh& mesh, VertexH v);
  bool in_patch(FaceId face) const;

  const Model& model_;
  std::vector<FaceId> patch_;  // sorted
  std::vector<std::vector<FaceId>> sides_;
  std::vector<std::vector<FaceId>> faces_at_;  // by VertexId of the model
};

}  // namespace advlayers
