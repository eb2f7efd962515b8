#include "setting_lists.h"

#include "setting_rows.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

template <class Entry>
Entry entry_of(const py::handle& value, const std::string& list,
               const std::vector<Row<Entry>>& rows) {
  if (!py::isinstance<py::dict>(value)) {
    throw InvalidInput(list + " must hold dictionaries, got " + shown(value));
  }
  Entry entry;
  for (const auto& [key, item] : value.cast<py::dict>()) {
    const auto name = py::str(key).cast<std::string>();
    const Row<Entry>* row = row_of(rows, name);
    if (row == nullptr) {
      throw InvalidInput(std::string(list).append(": unknown key \"").append(name).append("\""));
    }
    set_member(*row, item, std::string(list).append(": ").append(name), entry);
  }
  return entry;
}

template <class Entry>
std::vector<Entry> entries_of(const py::handle& value, const std::string& list,
                              const std::string& wanted, const std::vector<Row<Entry>>& rows) {
  if (py::isinstance<py::str>(value) || !py::isinstance<py::iterable>(value)) {
    throw InvalidInput(list + " must be " + wanted + ", got " + shown(value));
  }
  std::vector<Entry> entries;
  for (const py::handle item : value) entries.push_back(entry_of(item, list, rows));
  return entries;
}

}  // namespace

void set_walls(const py::handle& value, Settings& settings) {
  if (py::isinstance<py::str>(value) && value.cast<std::string>() == "all") return;
  settings.walls_all = false;
  settings.walls = entries_of(value, "walls", "\"all\" or a list", wall_rows());
  for (const WallSpec& wall : settings.walls) {
    if (wall.edges.empty()) throw InvalidInput("walls: \"edges\" is missing or empty");
  }
}

void set_sizes(const py::handle& value, Settings& settings) {
  settings.sizes = entries_of(value, "sizes", "a list", size_rows());
}

void set_refinements(const py::handle& value, Settings& settings) {
  settings.refinements = entries_of(value, "refinements", "a list", refinement_rows());
}

void set_periodic(const py::handle& value, Settings& settings) {
  settings.periodic = entries_of(value, "periodic", "a list", periodic_rows());
}

WallSpec wall_of(const py::handle& value) { return entry_of(value, "walls", wall_rows()); }

}  // namespace advlayers::python
