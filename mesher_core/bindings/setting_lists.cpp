#include "setting_lists.h"

#include "setting_values.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

template <class Entry>
struct Key {
  const char* name;
  void (*set)(const py::handle& value, Entry& entry);
};

const Key<WallSpec> kWallKeys[] = {
    {"edges",
     [](const py::handle& v, WallSpec& w) { w.edges = names<EdgeId>(v, "walls: edges", "Edge"); }},
    {"faces",
     [](const py::handle& v, WallSpec& w) { w.faces = names<FaceId>(v, "walls: faces", "Face"); }},
    {"first_height",
     [](const py::handle& v, WallSpec& w) { w.first_height = number(v, "walls: first_height"); }},
    {"end_height",
     [](const py::handle& v, WallSpec& w) { w.end_height = number(v, "walls: end_height"); }},
    {"aspect_ratio",
     [](const py::handle& v, WallSpec& w) { w.aspect_ratio = number(v, "walls: aspect_ratio"); }},
    {"turning_angle",
     [](const py::handle& v, WallSpec& w) { w.turning_angle = number(v, "walls: turning_angle"); }},
    {"growth", [](const py::handle& v, WallSpec& w) { w.growth = number(v, "walls: growth"); }},
    {"layers", [](const py::handle& v, WallSpec& w) { w.layers = count(v, "walls: layers"); }},
    {"thickness",
     [](const py::handle& v, WallSpec& w) { w.thickness = number(v, "walls: thickness"); }},
};

const Key<SizeSpec> kSizeKeys[] = {
    {"edges",
     [](const py::handle& v, SizeSpec& s) { s.edges = names<EdgeId>(v, "sizes: edges", "Edge"); }},
    {"faces",
     [](const py::handle& v, SizeSpec& s) { s.faces = names<FaceId>(v, "sizes: faces", "Face"); }},
    {"size", [](const py::handle& v, SizeSpec& s) { s.size = number(v, "sizes: size"); }},
    {"segments",
     [](const py::handle& v, SizeSpec& s) { s.segments = count(v, "sizes: segments"); }},
    {"cluster", [](const py::handle& v, SizeSpec& s) { s.cluster = number(v, "sizes: cluster"); }},
    {"both_ends",
     [](const py::handle& v, SizeSpec& s) { s.both_ends = flag(v, "sizes: both_ends"); }},
};

const Key<Refinement> kRefinementKeys[] = {
    {"point", [](const py::handle& v, Refinement& r) { r.point = point(v, "refinements: point"); }},
    {"size", [](const py::handle& v, Refinement& r) { r.size = number(v, "refinements: size"); }},
    {"radius",
     [](const py::handle& v, Refinement& r) { r.radius = number(v, "refinements: radius"); }},
};

template <class Entry, std::size_t kCount>
Entry entry_of(const py::handle& value, const std::string& list, const Key<Entry> (&keys)[kCount]) {
  if (!py::isinstance<py::dict>(value)) {
    throw InvalidInput(list + " must hold dictionaries, got " + shown(value));
  }
  Entry entry;
  for (const auto& [key, item] : value.cast<py::dict>()) {
    const auto name = py::str(key).cast<std::string>();
    const Key<Entry>* known = nullptr;
    for (const Key<Entry>& k : keys) {
      if (name == k.name) known = &k;
    }
    if (known == nullptr)
      throw InvalidInput(std::string(list).append(": unknown key \"").append(name).append("\""));
    known->set(item, entry);
  }
  return entry;
}

template <class Entry, std::size_t kCount>
std::vector<Entry> entries_of(const py::handle& value, const std::string& list,
                              const std::string& wanted, const Key<Entry> (&keys)[kCount]) {
  if (py::isinstance<py::str>(value) || !py::isinstance<py::iterable>(value)) {
    throw InvalidInput(list + " must be " + wanted + ", got " + shown(value));
  }
  std::vector<Entry> entries;
  for (const py::handle item : value) entries.push_back(entry_of(item, list, keys));
  return entries;
}

}  // namespace

void set_walls(const py::handle& value, Settings& settings) {
  if (py::isinstance<py::str>(value) && value.cast<std::string>() == "all") return;
  settings.walls_all = false;
  settings.walls = entries_of(value, "walls", "\"all\" or a list", kWallKeys);
  for (const WallSpec& wall : settings.walls) {
    if (wall.edges.empty()) throw InvalidInput("walls: \"edges\" is missing or empty");
  }
}

void set_sizes(const py::handle& value, Settings& settings) {
  settings.sizes = entries_of(value, "sizes", "a list", kSizeKeys);
}

void set_refinements(const py::handle& value, Settings& settings) {
  settings.refinements = entries_of(value, "refinements", "a list", kRefinementKeys);
}

}  // namespace advlayers::python
