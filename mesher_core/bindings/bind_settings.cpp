#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"
#include "bindings.h"
#include "initial_mesh_arrays.h"
#include "setting_lists.h"
#include "setting_rows.h"
#include "sizing/resolve_wall.h"
#include "sizing/schema.h"
#include "sizing/settings.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

constexpr const char* kIsotropic = "isotropic";

void set_layers(const py::handle& value, Settings& settings) {
  if (py::isinstance<py::str>(value)) {
    if (value.cast<std::string>() != kIsotropic) {
      throw InvalidInput("layers must be a number or \"isotropic\", got " + shown(value));
    }
    settings.end = EndOfGrowth::kIsotropic;
    return;
  }
  settings.layers = count(value, "layers");
  settings.end = settings.layers == 0 ? EndOfGrowth::kFrontsClose : EndOfGrowth::kLayers;
}

py::object layers_of(const Settings& settings) {
  if (settings.end == EndOfGrowth::kIsotropic) return py::str(kIsotropic);
  return py::int_(settings.layers);
}

bool is_all(const py::handle& value) {
  return py::isinstance<py::str>(value) && value.cast<std::string>() == "all";
}

void set_faces(const py::handle& value, Settings& settings) {
  if (is_all(value)) return;
  settings.faces = names<FaceId>(value, "faces", "Face");
  if (settings.faces.empty()) throw InvalidInput("faces must not be empty");
}

void set(const Row<Settings>& row, const py::handle& value, Settings& settings) {
  switch (row.kind) {
    case Kind::kAllFaces:
      return set_faces(value, settings);
    case Kind::kLayers:
      return set_layers(value, settings);
    case Kind::kWalls:
      return set_walls(value, settings);
    case Kind::kSizes:
      return set_sizes(value, settings);
    case Kind::kRefinements:
      return set_refinements(value, settings);
    case Kind::kPeriodic:
      return set_periodic(value, settings);
    case Kind::kInitialMesh:
      return set_initial_mesh(value, settings);
    default:
      set_member(row, value, row.key, settings);
  }
}

Settings settings_of(const py::kwargs& keywords) {
  Settings settings;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    const Row<Settings>* row = row_of(mesh_rows(), name);
    if (row == nullptr) throw InvalidInput("unknown setting \"" + name + "\"");
    set(*row, value, settings);
  }
  for (const Row<Settings>& row : mesh_rows()) {
    if (row.required && !keywords.contains(row.key)) {
      throw InvalidInput(std::string("setting \"") + row.key + "\" is missing");
    }
  }
  return settings;
}

// As a job would say it; what only the core holds, such as lists of walls, is not told again.
py::object value_of(const Row<Settings>& row, const Settings& settings) {
  switch (row.kind) {
    case Kind::kLayers:
      return layers_of(settings);
    case Kind::kAllFaces:
      if (settings.faces.empty()) return py::str("all");
      break;
    case Kind::kWalls:
      return settings.walls_all ? py::object(py::str("all")) : py::object(py::none());
    case Kind::kSizes:
    case Kind::kRefinements:
    case Kind::kPeriodic:
      return py::tuple();
    default:
      break;
  }
  return member_of(row, settings);
}

template <class Owner>
py::object value_of(const Row<Owner>& row, const Owner& owner) {
  return member_of(row, owner);
}

std::string describe(const Settings& settings) {
  return "<Settings: size " + shown(py::float_(settings.size)) + ", first_height " +
         shown(py::float_(settings.first_height)) + ", growth " +
         shown(py::float_(settings.growth)) + ", layers " + shown(layers_of(settings)) + ">";
}

py::object bound(double value) {
  return std::isfinite(value) ? py::object(py::float_(value)) : py::object(py::none());
}

template <class Owner>
py::list told(const std::vector<Row<Owner>>& rows) {
  py::list list;
  static const Owner defaults;  // no temporary: GCC 12 takes its padding for members, and warns
  for (const Row<Owner>& row : rows) {
    py::dict entry;
    entry["key"] = row.key;
    entry["kind"] = kind_name(row.kind);
    entry["unit"] = row.unit;
    entry["lowest"] = bound(row.range.lowest);
    entry["highest"] = bound(row.range.highest);
    entry["above"] = row.range.above;
    entry["below"] = row.range.below;
    py::list choices;
    for (const char* choice : row.names()) choices.append(choice);
    entry["choices"] = py::tuple(choices);
    entry["required"] = row.required;
    entry["default"] = row.required ? py::object(py::none()) : value_of(row, defaults);
    entry["doc"] = row.doc;
    list.append(entry);
  }
  return list;
}

py::dict schema() {
  py::dict tables;
  tables["mesh"] = told(mesh_rows());
  tables["walls"] = told(wall_rows());
  tables["sizes"] = told(size_rows());
  tables["refinements"] = told(refinement_rows());
  tables["periodic"] = told(periodic_rows());
  return tables;
}

py::dict resolve_wall(const Settings& settings, const py::dict& entry) {
  const ResolvedWall wall = advlayers::resolve_wall(wall_of(entry), settings);
  const bool isotropic = wall.end == EndOfGrowth::kIsotropic;
  py::dict found;
  found["first_height"] = shown_value(wall.first_height);
  found["end_height"] = shown_value(wall.end_height);
  found["growth"] = wall.growth;
  found["layers"] = isotropic ? py::object(py::str(kIsotropic)) : shown_value(wall.layers);
  found["expected_layers"] = wall.layers;
  found["thickness"] = shown_value(wall.thickness);
  return found;
}

std::string doc_of_settings() {
  std::string doc = "What is asked for: keywords only. Lengths in mm, angles in degrees.\n";
  for (const Row<Settings>& row : mesh_rows()) {
    const std::string unit = *row.unit == '\0' ? "" : std::string(" [") + row.unit + "]";
    doc += std::string("\n") + row.key + unit + (row.required ? " (needed)" : "") + ": " + row.doc;
  }
  return doc +
         "\n\nRaises InvalidInput naming the setting and its value. Values that depend on the "
         "model are\nchecked by Mesher.";
}

}  // namespace

void bind_settings(py::module_& module) {
  static const std::string kDoc = doc_of_settings();
  py::class_<Settings> kind(module, "Settings", kDoc.c_str());
  kind.def(py::init(&settings_of)).def("__repr__", &describe);
  for (const Row<Settings>& row : mesh_rows()) {
    if (row.kind == Kind::kInitialMesh || row.kind == Kind::kSizes ||
        row.kind == Kind::kRefinements || row.kind == Kind::kPeriodic || row.kind == Kind::kWalls) {
      continue;
    }
    kind.def_property_readonly(
        row.key, [&row](const Settings& settings) { return value_of(row, settings); }, row.doc);
  }
  module.def("schema", &schema,
             "The rows of all settings: key, kind, unit, range, choices, default and doc, by table "
             "(mesh, walls, sizes, refinements, periodic).");
  module.def("resolve_wall", &resolve_wall, py::arg("settings"), py::arg("wall") = py::dict(),
             "What a wall of these settings comes to: first_height and end_height [mm], growth,\n"
             "layers as asked, expected_layers (0: open) and the thickness [mm] of those; None "
             "where that\nfollows from the mesh. wall: an entry of the list of walls; its edges "
             "may be left out.\n\nRaises InvalidInput where it contradicts itself.");
}

}  // namespace advlayers::python
