// Whether the faces of a file came out of OpenCASCADE's reader. For the sources of geometry/ alone.
#pragma once

#include <TopoDS_Shape.hxx>

#include "geometry/step_text.h"

class IGESControl_Reader;
class STEPControl_Reader;

namespace advlayers {

// Throw InvalidInput with the entity of a face that is not in the shape, or has lost a bound there:
// the readers leave out what they cannot make, and say nothing.
void refuse_lost_faces(STEPControl_Reader& reader, const TopoDS_Shape& shape, const StepText& text);
void refuse_lost_faces(IGESControl_Reader& reader, const TopoDS_Shape& shape);

}  // namespace advlayers
