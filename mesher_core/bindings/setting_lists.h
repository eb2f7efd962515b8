// The settings that are lists of dictionaries.
#pragma once

#include <pybind11/pybind11.h>

#include "sizing/settings.h"

namespace advlayers::python {

// Each throws InvalidInput naming the key.
void set_walls(const pybind11::handle& value, Settings& settings);
void set_sizes(const pybind11::handle& value, Settings& settings);
void set_refinements(const pybind11::handle& value, Settings& settings);
void set_periodic(const pybind11::handle& value, Settings& settings);

// One wall of such a list, which may leave its edges out here.
WallSpec wall_of(const pybind11::handle& value);

}  // namespace advlayers::python
