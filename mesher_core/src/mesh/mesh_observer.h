// Is told of every entity a mesh makes or deletes (paper, II.D). Called after the change, while
// the mesh is valid again.
#pragma once

#include "mesh/mesh_types.h"

namespace advlayers {

class SurfaceMesh;

class MeshObserver {
 public:
  virtual ~MeshObserver() = default;
  virtual void vertex_created(const SurfaceMesh&, VertexH) {}
  virtual void vertex_deleted(const SurfaceMesh&, VertexH) {}
  virtual void face_created(const SurfaceMesh&, FaceH) {}
  virtual void face_changed(const SurfaceMesh&, FaceH) {}
  virtual void face_deleted(const SurfaceMesh&, FaceH) {}
};

}  // namespace advlayers
