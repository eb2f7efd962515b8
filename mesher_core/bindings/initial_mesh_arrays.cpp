#include "initial_mesh_arrays.h"

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>
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

// Of a node; the core has 32 bits for it, an array may have 64.
int index(std::int64_t node, py::ssize_t triangle, py::ssize_t count) {
  if (node >= 0 && node < count) return static_cast<int>(node);
  throw InvalidInput(
      "{}: {}", "initial_mesh",
      Sentence("triangle {} (from 0) has node {}, but there are {}", triangle, node, count));
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
  const auto triangles = rows_of_three<std::int64_t>(pair[1], "triangles", "iu");
  auto mesh = std::make_shared<InitialMesh>();
  for (py::ssize_t i = 0; i < points.size() / 3; ++i) {
    mesh->points.emplace_back(points.at(i, 0), points.at(i, 1), points.at(i, 2));
  }
  for (py::ssize_t t = 0; t < triangles.size() / 3; ++t) {
    std::array<int, 3>& corners = mesh->triangles.emplace_back();
    for (py::ssize_t k = 0; k < 3; ++k) {
      corners[static_cast<std::size_t>(k)] = index(triangles.at(t, k), t, points.size() / 3);
    }
  }
  settings.initial_mesh = std::move(mesh);
}

}  // namespace advlayers::python
