// The kinds of CAD files.
#pragma once

#include <string>

namespace advlayers {

enum class FileKind { kBrep, kStep, kIges, kStl };

// By the ending, in any case. Throws InvalidInput.
FileKind file_kind(const std::string& path);
const char* kind_name(FileKind kind);

}  // namespace advlayers
