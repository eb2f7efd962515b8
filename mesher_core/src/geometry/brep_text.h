// A reading of BREP text for its grammar alone. OpenCASCADE's reader takes any text for good: on a
// cut-off or damaged one it runs into null geometry and crashes, which no exception tells.
#pragma once

#include <string>

namespace advlayers {

// Throws InvalidInput, with the line and what is wrong there, unless every table of the text is
// whole and every reference in it leads to an entry.
void check_brep_text(const std::string& text);

}  // namespace advlayers
