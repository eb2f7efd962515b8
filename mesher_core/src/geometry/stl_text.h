// The triangles of an STL file, of text or of bytes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "base/types.h"

namespace advlayers {

// Throws InvalidInput, with the line or the triangle and what is wrong there, unless the file is
// whole: the number of triangles that it begins with and its length agree, or every triangle and
// every solid in it has an end.
std::vector<std::array<Vec3, 3>> stl_triangles(const std::string& bytes);

}  // namespace advlayers
