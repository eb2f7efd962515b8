// The OpenCASCADE that the core is built with, for reports.
#pragma once

#include <string>

namespace advlayers {

std::string kernel_version();

}  // namespace advlayers
