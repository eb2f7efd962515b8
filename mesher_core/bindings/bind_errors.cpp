#include "base/error.h"
#include "bindings.h"

namespace py = pybind11;

namespace advlayers::python {

void bind_errors(py::module_& module) {
  py::register_exception<InvalidInput>(module, "InvalidInput", PyExc_ValueError).doc() =
      "The caller's fault: a setting, a name, a file that is not there.";
  py::register_exception<GeometryError>(module, "GeometryError", PyExc_RuntimeError).doc() =
      "The shape's fault: nothing in it that could be meshed.";
  py::register_exception<Cancelled>(module, "Cancelled", PyExc_Exception).doc() =
      "A stop that was asked for with Mesher.cancel().";
  py::register_exception<InternalError>(module, "InternalError", PyExc_RuntimeError).doc() =
      "A fault of this library: please report it with the model.";
}

}  // namespace advlayers::python
