// Points spread over a trimmed face: where to start the search for a foot without a seed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/face_domain.h"
#include "geometry/face_surface.h"

namespace advlayers {

class FaceSamples {
 public:
  FaceSamples(const Face& face, const FaceSurface& surface, const FaceDomain& domain);

  using EdgePointAt = std::function<SurfacePoint(const CoEdge&, double)>;
  SurfacePoint closest(FaceId id, const Vec3& xyz, const EdgePointAt& at) const;

 private:
  std::vector<std::size_t> starts(const Vec3& xyz) const;
  SurfacePoint closest_on_boundary(const Vec3& xyz, const EdgePointAt& at) const;

  struct Sample {
    double u, v;
    Vec3 xyz;
  };
  const FaceSurface* surface_;
  const FaceDomain* domain_;
  std::vector<Sample> samples_;  // of the grid, row by row, then of the boundary
  std::size_t rows_ = 0, columns_ = 0;
};

}  // namespace advlayers
