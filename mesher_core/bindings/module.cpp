#include "bindings.h"
#include "geometry/kernel_version.h"

PYBIND11_MODULE(_core, module) {
  using namespace advlayers::python;
  module.doc() =
      "Layered quad-dominant surface meshes on CAD faces. Lengths in mm, angles in degrees.";
  module.attr("__version__") = ADVLAYERS_VERSION;
  module.attr("kernel_version") = advlayers::kernel_version();
  bind_errors(module);
  bind_context(module);
  bind_child(module);
  bind_model(module);
  bind_settings(module);
  bind_estimate(module);
  bind_result(module);
  bind_mesher(module);
  bind_number_rows(module);
}
