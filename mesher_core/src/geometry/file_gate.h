// The one door for CAD files.
#pragma once

#include <string>

#include "base/run_context.h"

namespace advlayers {

// What .step .stp .iges .igs .brep .brp .stl files hold, by the ending in any case, as BREP text in
// mm. The file is checked and read by the program advlayers-read, with limits of time and memory,
// by its size: what reading it, or making a model of it sewn by `sew_tolerance` [mm], crashes or
// hangs there. Throws InvalidInput, naming the file, where it cannot be read, or not all that is in
// it; GeometryError where it holds no face; Cancelled.
std::string brep_of_file(const RunContext& context, const std::string& path, double sew_tolerance);

// Where the program lies that reads files; until then it is looked for beside the library or the
// program that this is linked into.
void set_reader_program(const std::string& path);

// That program's work: what brep_of_file() has asked for.
std::string brep_asked_for(const std::string& request);

}  // namespace advlayers
