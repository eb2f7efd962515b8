#include "geometry/kernel_version.h"

#include <Standard_Version.hxx>

namespace advlayers {

std::string kernel_version() { return OCC_VERSION_COMPLETE; }

}  // namespace advlayers
