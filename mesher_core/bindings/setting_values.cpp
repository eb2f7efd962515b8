#include "setting_values.h"

namespace py = pybind11;

namespace advlayers::python {

std::string shown(const py::handle& value) { return py::repr(value).cast<std::string>(); }

// The zero-based number in a CAD name such as "Edge7".
std::int32_t number_in_name(const py::handle& value, const std::string& setting,
                            const std::string& kind) {
  const std::string wanted = setting + " must name " + kind + "s, like \"" + kind + "7\"";
  if (!py::isinstance<py::str>(value)) throw InvalidInput(wanted + ", got " + shown(value));
  const auto name = value.cast<std::string>();
  const bool prefixed = name.compare(0, kind.size(), kind) == 0;
  const std::string digits = prefixed ? name.substr(kind.size()) : "";
  const bool numeric = !digits.empty() && digits.size() < 10 && digits.front() != '0' &&
                       digits.find_first_not_of("0123456789") == std::string::npos;
  if (!numeric) throw InvalidInput(wanted + ", got " + shown(value));
  return static_cast<std::int32_t>(std::stol(digits) - 1);
}

double number(const py::handle& value, const std::string& setting) {
  const bool plain = !py::isinstance<py::bool_>(value) && PyNumber_Check(value.ptr()) == 1;
  const double real = plain ? PyFloat_AsDouble(value.ptr()) : 0.0;
  const bool failed = PyErr_Occurred() != nullptr;  // a complex number, or one out of range
  PyErr_Clear();
  if (plain && !failed) return real;
  throw InvalidInput(setting + " must be a number, got " + shown(value));
}

int count(const py::handle& value, const std::string& setting) {
  py::object whole;  // of numpy's integers, too
  if (!py::isinstance<py::bool_>(value)) {
    whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  }
  PyErr_Clear();
  if (!whole) {
    throw InvalidInput(setting + " must be a whole number, got " + shown(value));
  }
  try {
    return whole.cast<int>();
  } catch (const py::cast_error&) {
    throw InvalidInput(setting + " is out of range: " + shown(value));
  }
}

bool flag(const py::handle& value, const std::string& setting) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  throw InvalidInput(setting + " must be true or false, got " + shown(value));
}

std::size_t choice(const py::handle& value, const std::string& setting,
                   const std::vector<const char*>& choices) {
  const auto name = py::isinstance<py::str>(value) ? value.cast<std::string>() : "";
  std::string allowed;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    if (name == choices[i]) return i;
    allowed += (i > 0 ? " or \"" : "\"") + std::string(choices[i]) + "\"";
  }
  throw InvalidInput(setting + " must be " + allowed + ", got " + shown(value));
}

Vec3 point(const py::handle& value, const std::string& setting) {
  const bool listed = py::isinstance<py::sequence>(value) && !py::isinstance<py::str>(value);
  if (!listed || py::len(value) != 3) {
    throw InvalidInput(setting + " must be three numbers, got " + shown(value));
  }
  const auto list = py::reinterpret_borrow<py::sequence>(value);
  Vec3 xyz;
  for (int k = 0; k < 3; ++k) xyz[k] = number(list[static_cast<std::size_t>(k)], setting);
  return xyz;
}

}  // namespace advlayers::python
