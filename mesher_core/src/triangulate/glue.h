// Makes one surface mesh of a patch from the triangulations of its faces.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "mesh/surface_mesh.h"
#include "triangulate/lifted_triangulation.h"

namespace advlayers {

struct GluedMesh {
  SurfaceMesh mesh;
  std::vector<double> sizes;  // wanted edge length [mm], by vertex
};

// Joins the faces along seams and smooth edges, and closes poles. Border edges are frozen and name
// their CAD edge. Where the result would be no manifold (a face closed in a direction with
// too few triangles around it), edges of the sheets are divided first. Throws BoundaryTooCoarse
// where boundary edges alone are the reason.
GluedMesh glue_sheets(const RunContext& context, std::vector<LiftedTriangulation>& sheets,
                      const Discretization& boundary);

}  // namespace advlayers
