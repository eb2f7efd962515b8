// The boundary of a face as closed loops of co-edges. For the sources of geometry/ alone.
#pragma once

#include "geometry/occt_shape.h"

namespace advlayers {

// Fills face.loops and the face's curves in (u, v), and sets face.defect where the boundary cannot
// be made out. Wants the face's kind, periods and bounds, and the model's edges. A curve that is
// missing in (u, v) is computed, and stored in the shape's own edge.
void build_loops(const TopoDS_Face& shape_face, const Model::Shape& shape,
                 const std::vector<Edge>& edges, Face& face, std::vector<Pcurve>& pcurves);

}  // namespace advlayers
