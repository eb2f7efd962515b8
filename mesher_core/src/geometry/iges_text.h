// Whether an IGES file is whole, by its text alone: the reader crashes on parts of one.
#pragma once

#include <string>

namespace advlayers {

// Throws InvalidInput unless the sections hold the records that the last line counts, and each
// entry of the directory is one and leads to parameters of its own type. The compressed form, which
// has no records of a fixed length, passes.
void check_iges_text(const std::string& text);

}  // namespace advlayers
