// The parts of the Python module advlayers_core._core; each adds its names to the module.
#pragma once

#include <pybind11/pybind11.h>

namespace advlayers::python {

void bind_errors(pybind11::module_& module);
void bind_context(pybind11::module_& module);
void bind_child(pybind11::module_& module);
void bind_estimate(pybind11::module_& module);
void bind_model(pybind11::module_& module);
void bind_settings(pybind11::module_& module);
void bind_result(pybind11::module_& module);
void bind_mesher(pybind11::module_& module);
void bind_number_rows(pybind11::module_& module);

}  // namespace advlayers::python
