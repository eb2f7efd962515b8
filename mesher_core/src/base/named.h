// Lists that give the members of an enumeration their names: one list for names and number.
#pragma once

#include <array>
#include <cstddef>

namespace advlayers {

template <class Id>
struct Named {
  Id id;
  const char* name;
};

// Whether the list has the enumeration's members in their order, so that they index it.
template <class Entry, std::size_t kCount>
constexpr bool in_order(const std::array<Entry, kCount>& list) {
  for (std::size_t k = 0; k < kCount; ++k) {
    if (static_cast<std::size_t>(list[k].id) != k) return false;
  }
  return true;
}

template <class Id, std::size_t kCount>
constexpr const char* name_in(const std::array<Named<Id>, kCount>& list, Id id) {
  return list[static_cast<std::size_t>(id)].name;
}

}  // namespace advlayers
