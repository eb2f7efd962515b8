#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "bindings.h"
#include "geometry/model.h"
#include "initial_mesh_arrays.h"
#include "setting_lists.h"
#include "setting_values.h"
#include "sizing/settings.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

void set_layers(const py::handle& value, Settings& settings) {
  if (py::isinstance<py::str>(value)) {
    if (value.cast<std::string>() != "isotropic") {
      throw InvalidInput("layers must be a number or \"isotropic\", got " + shown(value));
    }
    settings.end = EndOfGrowth::kIsotropic;
    return;
  }
  settings.layers = count(value, "layers");
  settings.end = settings.layers == 0 ? EndOfGrowth::kFrontsClose : EndOfGrowth::kLayers;
}

void set_core(const py::handle& value, Settings& settings) {
  const auto name = py::isinstance<py::str>(value) ? value.cast<std::string>() : "";
  if (name != "quads" && name != "triangles") {
    throw InvalidInput("core must be \"quads\" or \"triangles\", got " + shown(value));
  }
  settings.core = name == "quads" ? CoreElements::kQuads : CoreElements::kTriangles;
}

void set_faces(const py::handle& value, Settings& settings) {
  if (py::isinstance<py::str>(value) && value.cast<std::string>() == "all") return;
  settings.faces = names<FaceId>(value, "faces", "Face");
  if (settings.faces.empty()) throw InvalidInput("faces must not be empty");
}

// One row per keyword: the table that the constructor follows.
struct Keyword {
  const char* name;
  void (*set)(const py::handle& value, Settings& settings);
};

const Keyword kKeywords[] = {
    {"size", [](const py::handle& v, Settings& s) { s.size = number(v, "size"); }},
    {"first_height",
     [](const py::handle& v, Settings& s) { s.first_height = number(v, "first_height"); }},
    {"growth", [](const py::handle& v, Settings& s) { s.growth = number(v, "growth"); }},
    {"layers", set_layers},
    {"feature_angle",
     [](const py::handle& v, Settings& s) { s.feature_angle = number(v, "feature_angle"); }},
    {"curvature_angle",
     [](const py::handle& v, Settings& s) { s.curvature_angle = number(v, "curvature_angle"); }},
    {"size_growth",
     [](const py::handle& v, Settings& s) { s.size_growth = number(v, "size_growth"); }},
    {"sizes", set_sizes},
    {"refinements", set_refinements},
    {"core", set_core},
    {"order", [](const py::handle& v, Settings& s) { s.order = count(v, "order"); }},
    {"walls", set_walls},
    {"match",
     [](const py::handle& v, Settings& s) { s.match_edges = names<EdgeId>(v, "match", "Edge"); }},
    {"off",
     [](const py::handle& v, Settings& s) { s.off_edges = names<EdgeId>(v, "off", "Edge"); }},
    {"boundary", [](const py::handle& v,
                    Settings& s) { s.boundary_edges = names<EdgeId>(v, "boundary", "Edge"); }},
    {"smooth",
     [](const py::handle& v, Settings& s) { s.smooth_edges = names<EdgeId>(v, "smooth", "Edge"); }},
    {"faces", set_faces},
    {"initial_mesh", set_initial_mesh},
    {"threads", [](const py::handle& v, Settings& s) { s.threads = count(v, "threads"); }},
};

Settings settings_of(const py::kwargs& keywords) {
  Settings settings;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    const Keyword* known = nullptr;
    for (const Keyword& keyword : kKeywords) {
      if (name == keyword.name) known = &keyword;
    }
    if (known == nullptr) throw InvalidInput("unknown setting \"" + name + "\"");
    known->set(value, settings);
  }
  for (const char* needed : {"size", "first_height"}) {
    if (!keywords.contains(needed)) {
      throw InvalidInput(std::string("setting \"") + needed + "\" is missing");
    }
  }
  return settings;
}

py::object layers_of(const Settings& settings) {
  if (settings.end == EndOfGrowth::kIsotropic) return py::str("isotropic");
  return py::int_(settings.layers);
}

std::string describe(const Settings& settings) {
  return "<Settings: size " + shown(py::float_(settings.size)) + ", first_height " +
         shown(py::float_(settings.first_height)) + ", growth " +
         shown(py::float_(settings.growth)) + ", layers " + shown(layers_of(settings)) + ">";
}

constexpr const char* kDoc =
    "What is asked for. Settings(*, size, first_height, growth=1.2, layers=0, feature_angle=0,\n"
    "curvature_angle=20, size_growth=1.4, sizes=[], refinements=[], core=\"quads\", order=1,\n"
    "walls=\"all\", match=[], off=[], boundary=[], smooth=[], faces=\"all\", initial_mesh=None, "
    "threads=0)\n\n"
    "size, first_height in mm; angles in degrees. layers: a number, 0 = until the fronts close, "
    "or\n"
    "\"isotropic\". walls: \"all\", or a list of {\"edges\": [\"Edge3\"], \"faces\": [\"Face1\"],\n"
    "\"first_height\", \"end_height\", \"aspect_ratio\", \"turning_angle\", \"growth\", "
    "\"layers\",\n"
    "\"thickness\"}. sizes: a list of {\"edges\", \"faces\", \"size\", \"segments\", \"cluster\",\n"
    "\"both_ends\"}; refinements: a list of {\"point\": [x, y, z], \"size\", \"radius\"}.\n"
    "initial_mesh: (points, triangles), arrays (n, 3) [mm] and (m, 3), of the shape: its nodes\n"
    "inside the faces are where the triangulation starts, its spacing the size where it is finer.\n"
    "order: 2 = with a node in the middle of each mesh edge, on the shape.\n"
    "threads: 0 = as many as there are.\n\n"
    "Raises InvalidInput naming the setting and its value. Values that depend on the model are\n"
    "checked by Mesher.";

}  // namespace

void bind_settings(py::module_& module) {
  py::class_<Settings>(module, "Settings", kDoc)
      .def(py::init(&settings_of))
      .def_readonly("size", &Settings::size, "Target edge length [mm].")
      .def_readonly("first_height", &Settings::first_height, "Height of the first layer [mm].")
      .def_readonly("growth", &Settings::growth, "Ratio of each height to the one before.")
      .def_property_readonly("layers", &layers_of, "Number of layers, or \"isotropic\".")
      .def_readonly("feature_angle", &Settings::feature_angle, "[deg]")
      .def_readonly("curvature_angle", &Settings::curvature_angle, "[deg]")
      .def_readonly("size_growth", &Settings::size_growth, "Most that neighbouring edges differ.")
      .def_property_readonly(
          "core",
          [](const Settings& s) { return s.core == CoreElements::kQuads ? "quads" : "triangles"; })
      .def_readonly("order", &Settings::order, "1, or 2: with mid nodes.")
      .def_readonly("threads", &Settings::threads)
      .def("__repr__", &describe);
}

}  // namespace advlayers::python
