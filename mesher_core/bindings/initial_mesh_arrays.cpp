#include "initial_mesh_arrays.h"

#include <pybind11/numpy.h>

#include <string>

#include "base/error.h"
#include "setting_values.h"
#include "sizing/initial_mesh.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

template <class Number>
using Rows = py::array_t<Number, py::array::c_style | py::array::forcecast>;

// An array of three columns; an empty one may have any shape.
template <class Number>
Rows<Number> rows_of_three(const py::handle& value, const char* what, const char* kinds) {
  const py::array given = py::array::ensure(value);
  const bool typed = given && std::string(kinds).find(given.dtype().kind()) != std::string::npos;
  const bool shaped = given && given.ndim() == 2 && given.shape(1) == 3;
  if (!given || (given.size() > 0 && !(typed && shaped))) {
    PyErr_Clear();
    throw InvalidInput(std::string("initial_mesh: its ") + what +
                       " must be numbers in three columns" +
                       (shaped ? ", got some of type " + shown(given.dtype()) : ""));
  }
  return Rows<Number>::ensure(given);
}

}  // namespace

void set_initial_mesh(const py::handle& value, Settings& settings) {
  if (value.is_none()) return;
  if (!py::isinstance<py::sequence>(value) || py::isinstance<py::str>(value) ||
      py::len(value) != 2) {
    throw InvalidInput("initial_mesh must be a pair of points and triangles");
  }
  const auto pair = py::reinterpret_borrow<py::sequence>(value);
  const auto points = rows_of_three<double>(pair[0], "points", "fiu");
  const auto triangles = rows_of_three<int>(pair[1], "triangles", "iu");
  auto mesh = std::make_shared<InitialMesh>();
  for (py::ssize_t i = 0; i < points.size() / 3; ++i) {
    mesh->points.emplace_back(points.at(i, 0), points.at(i, 1), points.at(i, 2));
  }
  for (py::ssize_t t = 0; t < triangles.size() / 3; ++t) {
    mesh->triangles.push_back({triangles.at(t, 0), triangles.at(t, 1), triangles.at(t, 2)});
  }
  settings.initial_mesh = std::move(mesh);
}

}  // namespace advlayers::python
