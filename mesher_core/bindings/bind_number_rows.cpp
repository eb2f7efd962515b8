#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/number_rows.h"
#include "bindings.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

NumberColumn::Type type_of(const py::array& array) {
  if (py::isinstance<py::array_t<double>>(array)) return NumberColumn::Type::Double;
  if (py::isinstance<py::array_t<std::int32_t>>(array)) return NumberColumn::Type::Int32;
  if (py::isinstance<py::array_t<std::int64_t>>(array)) return NumberColumn::Type::Int64;
  throw InternalError("rows are made of arrays of float64, int32 or int64");
}

py::bytes number_rows(const std::string& form, const py::args& arrays) {
  std::vector<NumberColumn> columns;
  py::ssize_t rows = -1;
  for (const py::handle& given : arrays) {
    if (!py::isinstance<py::array>(given)) throw InternalError("rows are made of arrays");
    const auto array = py::reinterpret_borrow<py::array>(given);
    if (array.ndim() < 1 || array.ndim() > 2 || (rows >= 0 && array.shape(0) != rows)) {
      throw InternalError("rows are made of arrays of as many rows each");
    }
    rows = array.shape(0);
    const py::ssize_t width = array.ndim() == 2 ? array.shape(1) : 1;
    const py::ssize_t apart = array.ndim() == 2 ? array.strides(1) : 0;
    const char* first = static_cast<const char*>(array.data());
    for (py::ssize_t k = 0; k < width; ++k) {
      columns.push_back({first + k * apart, array.strides(0), type_of(array)});
    }
  }
  std::string text;
  {
    const py::gil_scoped_release released;
    const RowForm rows_of(form);
    rows_of.append(columns, static_cast<std::size_t>(std::max<py::ssize_t>(rows, 0)), text);
  }
  return py::bytes(text);
}

}  // namespace

void bind_number_rows(py::module_& module) {
  module.def("number_rows", &number_rows, py::arg("form"),
             "Rows of numbers as text: `form` is that of one row, its numbers %d, %10d (integers), "
             "%25.16E, %r (shortest exact) or %16w (most digits in 16 characters); an array of k "
             "columns gives k numbers of each row.");
}

}  // namespace advlayers::python
