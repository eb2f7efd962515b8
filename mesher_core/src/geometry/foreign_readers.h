// OpenCASCADE's readers of files, and whether all that a file holds came out of them. They crash on
// some damaged files, and run on others without end: for a child process. For the sources of
// geometry/ alone.
#pragma once

#include <TopoDS_Shape.hxx>
#include <mutex>
#include <string>

#include "base/run_context.h"
#include "geometry/step_text.h"

namespace advlayers {

// The readers share static registers and print to the default messenger: whoever calls one holds
// this.
std::mutex& reader_mutex();

// Null where the text cannot be read. Throws InvalidInput where its grammar is broken; Cancelled.
TopoDS_Shape shape_of_brep(const RunContext& context, const std::string& text);
std::string brep_of_shape(const TopoDS_Shape& shape);

// OpenCASCADE's binary form, which FreeCAD's exportBinary() writes; null where it cannot be read.
bool is_binary_brep(const std::string& bytes);
TopoDS_Shape shape_of_binary_brep(const std::string& bytes);

// In mm; null where the file cannot be read. Throw InvalidInput where an entity did not arrive.
TopoDS_Shape shape_of_step(const std::string& path, const StepText& text);
TopoDS_Shape shape_of_iges(const std::string& path);

}  // namespace advlayers
