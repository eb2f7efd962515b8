// Joins faces that lie edge to edge without sharing the edges. For the sources of geometry/ alone.
#pragma once

#include "geometry/occt_shape.h"

namespace advlayers {

// Sews the shape and fills its maps of faces and edges in the order of the shape as it was given:
// each face keeps its number, and of edges that were joined the first lends the whole its number.
// The others' numbers stand for edges without curve and face; `pieces` says what they became.
// Sewing: BRepBuilderAPI_Sewing, also of three and more edges, cutting long edges where shorter
// ones lie along them. Throws GeometryError where OpenCASCADE fails, and Cancelled.
void sew_shape(const RunContext& context, Model::Shape& shape, double tolerance);

// A model of the shape, sewn before where the tolerance [mm] is not 0.
Model model_of_shape(const RunContext& context, std::unique_ptr<Model::Shape> shape,
                     double sew_tolerance);

}  // namespace advlayers
