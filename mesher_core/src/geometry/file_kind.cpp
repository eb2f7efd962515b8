#include "geometry/file_kind.h"

#include <algorithm>
#include <cctype>

#include "base/error.h"

namespace advlayers {
namespace {

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::size_t slash = path.find_last_of("/\\");
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

FileKind file_kind(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == "brep" || ending == "brp") return FileKind::kBrep;
  if (ending == "step" || ending == "stp") return FileKind::kStep;
  if (ending == "iges" || ending == "igs") return FileKind::kIges;
  if (ending == "stl") return FileKind::kStl;
  throw InvalidInput("{}: the ending is none of {}", path, ".step .stp .iges .igs .brep .brp .stl");
}

const char* kind_name(FileKind kind) {
  switch (kind) {
    case FileKind::kBrep:
      return "BREP";
    case FileKind::kStep:
      return "STEP";
    case FileKind::kIges:
      return "IGES";
    default:
      return "STL";
  }
}

}  // namespace advlayers
