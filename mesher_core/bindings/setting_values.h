// Python values of settings as the core's, each checked for its type alone.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "base/types.h"

namespace advlayers::python {

std::string shown(const pybind11::handle& value);

// The zero-based number in a CAD name such as "Edge7". All throw InvalidInput naming `setting`.
std::int32_t number_in_name(const pybind11::handle& value, const std::string& setting,
                            const std::string& kind);
double number(const pybind11::handle& value, const std::string& setting);
int count(const pybind11::handle& value, const std::string& setting);
bool flag(const pybind11::handle& value, const std::string& setting);
// The place among the choices of the one that is named.
std::size_t choice(const pybind11::handle& value, const std::string& setting,
                   const std::vector<const char*>& choices);
Vec3 point(const pybind11::handle& value, const std::string& setting);

template <class EntityId>
std::vector<EntityId> names(const pybind11::handle& value, const std::string& setting,
                            const std::string& kind) {
  if (pybind11::isinstance<pybind11::str>(value) ||
      !pybind11::isinstance<pybind11::iterable>(value)) {
    throw InvalidInput(setting + " must be a list of names like \"" + kind + "7\", got " +
                       shown(value));
  }
  std::vector<EntityId> ids;
  for (const pybind11::handle item : value) ids.emplace_back(number_in_name(item, setting, kind));
  return ids;
}

}  // namespace advlayers::python
