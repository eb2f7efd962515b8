// Python values into the members that rows of the schema name, and back.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <type_traits>
#include <vector>

#include "base/error.h"
#include "setting_values.h"
#include "sizing/schema.h"

namespace advlayers::python {

inline void read(const pybind11::handle& v, const std::string& name, double& out) {
  out = number(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, std::optional<double>& out) {
  out = number(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, int& out) {
  out = count(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, std::optional<int>& out) {
  out = count(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, bool& out) {
  out = flag(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, Vec3& out) {
  out = point(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, std::optional<Vec3>& out) {
  out = point(v, name);
}
inline void read(const pybind11::handle& v, const std::string& name, std::vector<EdgeId>& out) {
  out = names<EdgeId>(v, name, "Edge");
}
inline void read(const pybind11::handle& v, const std::string& name, std::vector<FaceId>& out) {
  out = names<FaceId>(v, name, "Face");
}

inline pybind11::object shown_value(double value) { return pybind11::float_(value); }
inline pybind11::object shown_value(int value) { return pybind11::int_(value); }
inline pybind11::object shown_value(bool value) { return pybind11::bool_(value); }
inline pybind11::object shown_value(const Vec3& p) {
  return pybind11::make_tuple(p.x(), p.y(), p.z());
}
template <class Value>
pybind11::object shown_value(const std::optional<Value>& value) {
  return value ? shown_value(*value) : pybind11::none();
}
inline std::string name_of(EdgeId edge) { return edge_name(edge); }
inline std::string name_of(FaceId face) { return face_name(face); }
template <class EntityId>
pybind11::object shown_value(const std::vector<EntityId>& ids) {
  pybind11::list list;
  for (const EntityId id : ids) list.append(name_of(id));
  return pybind11::tuple(list);
}

// Throws InvalidInput naming `name`.
template <class Owner>
void set_member(const Row<Owner>& row, const pybind11::handle& value, const std::string& name,
                Owner& owner) {
  std::visit(
      [&](auto place) {
        if constexpr (std::is_same_v<decltype(place), std::monostate>) {
          throw InternalError(name + " has no member");
        } else if constexpr (std::is_enum_v<std::decay_t<decltype(owner.*place)>>) {
          owner.*place =
              static_cast<std::decay_t<decltype(owner.*place)>>(choice(value, name, row.names()));
        } else {
          read(value, name, owner.*place);
        }
      },
      row.member);
}

// None where the row names no member.
template <class Owner>
pybind11::object member_of(const Row<Owner>& row, const Owner& owner) {
  return std::visit(
      [&owner, &row](auto place) -> pybind11::object {
        if constexpr (std::is_same_v<decltype(place), std::monostate>) {
          return pybind11::none();
        } else if constexpr (std::is_enum_v<std::decay_t<decltype(owner.*place)>>) {
          return pybind11::str(row.choices[static_cast<std::size_t>(owner.*place)]);
        } else {
          return shown_value(owner.*place);
        }
      },
      row.member);
}

// The row with that key, or none.
template <class Owner>
const Row<Owner>* row_of(const std::vector<Row<Owner>>& rows, const std::string& key) {
  for (const Row<Owner>& row : rows) {
    if (key == row.key) return &row;
  }
  return nullptr;
}

}  // namespace advlayers::python
