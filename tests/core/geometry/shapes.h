// Shapes of OpenCASCADE as models, and the properties that every sound model has.
#pragma once

#include <BRepTools.hxx>
#include <TopoDS_Shape.hxx>
#include <sstream>
#include <string>

#include "geometry/evaluator.h"
#include "geometry/model.h"

namespace advlayers::test {

inline std::string brep_text(const TopoDS_Shape& shape) {
  std::ostringstream text;
  BRepTools::Write(shape, text);
  return text.str();
}

inline Model model_of(const TopoDS_Shape& shape) {
  return read_brep(RunContext(), brep_text(shape));
}

}  // namespace advlayers::test
