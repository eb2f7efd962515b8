// The setting that is a pair of arrays.
#pragma once

#include <pybind11/pybind11.h>

#include "sizing/settings.h"

namespace advlayers::python {

// From None, or a pair of points (n, 3) and triangles (m, 3); throws InvalidInput naming what is
// neither. Indices and coordinates are checked by the mesher.
void set_initial_mesh(const pybind11::handle& value, Settings& settings);

}  // namespace advlayers::python
