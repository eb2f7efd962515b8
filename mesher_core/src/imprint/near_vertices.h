// The vertices of a mesh by place.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "mesh/surface_mesh.h"

namespace advlayers {

class NearVertices {
 public:
  explicit NearVertices(const SurfaceMesh& mesh);
  ~NearVertices();

  // The vertices nearest to p and their distances [mm], so many of them, the nearest first; equally
  // near ones by their numbers.
  std::vector<std::pair<double, VertexH>> nearest(const Vec3& p, std::size_t count) const;
  // The vertex has moved to where the mesh has it now.
  void moved(VertexH v, const Vec3& from);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace advlayers
