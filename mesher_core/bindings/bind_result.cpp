#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>

#include "bindings.h"
#include "geometry/model.h"
#include "mesh_view.h"
#include "mesher/wall_shortfalls.h"
#include "sentence_values.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "nodes are handed out as rows of three");

std::vector<int> numbers_from_one(const std::vector<FaceId>& faces) {
  std::vector<int> numbers;
  numbers.reserve(faces.size());
  for (const FaceId face : faces) numbers.push_back(face.value + 1);
  return numbers;
}

// A view that keeps its owner alive and refuses to be written to.
template <class Number>
py::array rows(const void* data, std::size_t count, std::size_t width, const py::object& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(count)};
  if (width > 1) shape.push_back(static_cast<py::ssize_t>(width));
  py::array array(py::dtype::of<Number>(), shape, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

const MeshResult& mesh_of(const py::object& self) { return self.cast<const MeshView&>().result; }

template <auto kMember>
py::array ints(const py::object& self) {
  const auto& values = mesh_of(self).*kMember;
  constexpr std::size_t kRowBytes = sizeof(typename std::decay_t<decltype(values)>::value_type);
  return rows<int>(values.data(), values.size(), kRowBytes / sizeof(int), self);
}

template <auto kMember>
py::array face_numbers(const py::object& self) {
  const std::vector<int>& values = self.cast<const MeshView&>().*kMember;
  return rows<int>(values.data(), values.size(), 1, self);
}

template <auto kMember>
py::array points(const py::object& self) {
  const auto& values = mesh_of(self).*kMember;
  return rows<double>(values.data(), values.size(), 3, self);
}

// By CAD edge, where it has any.
template <auto kMember>
py::dict of_edges(const py::object& self) {
  py::dict by_edge;
  const auto& lists = mesh_of(self).*kMember;
  constexpr std::size_t kRowBytes =
      sizeof(typename std::decay_t<decltype(lists)>::value_type::value_type);
  for (std::size_t e = 0; e < lists.size(); ++e) {
    if (lists[e].empty()) continue;
    by_edge[py::int_(e + 1)] =
        rows<int>(lists[e].data(), lists[e].size(), kRowBytes / sizeof(int), self);
  }
  return by_edge;
}

py::list patches(const py::object& self) {
  py::list list;
  for (const PatchReport& patch : mesh_of(self).patches) {
    py::list names;
    for (const FaceId face : patch.faces) names.append(face_name(face));
    py::dict entry;
    entry["patch"] = patch.patch.value;
    entry["faces"] = names;
    entry["layers"] = patch.layers;
    entry["quads"] = patch.quads;
    entry["triangles"] = patch.triangles;
    entry["events"] = patch.events;
    entry["triangles_by_cause"] = patch.triangles_by_cause;
    entry["vetoes"] = patch.vetoes;
    list.append(entry);
  }
  return list;
}

py::dict range(double least, double mean, double most) {
  py::dict entry;
  entry["min"] = least;
  entry["mean"] = mean;
  entry["max"] = most;
  return entry;
}

py::dict first_stops(const WallReport& wall) {
  py::dict by_reason;
  for (const auto& [reason, place] : wall.first_stops) {
    py::dict entry;
    entry["point"] = py::make_tuple(place.point.x(), place.point.y(), place.point.z());
    entry["layer"] = place.layer;
    by_reason[py::str(reason)] = entry;
  }
  return by_reason;
}

py::list shortfalls(const WallReport& wall) {
  py::list list;
  for (const Shortfall& shortfall : shortfalls_of(wall)) {
    py::dict entry;
    entry["code"] = shortfall.code;
    entry["text"] = shortfall.sentence.english();
    entry["form"] = shortfall.sentence.form();
    entry["values"] = values_of(shortfall.sentence);
    list.append(entry);
  }
  return list;
}

py::list walls(const py::object& self) {
  py::list list;
  for (const WallReport& wall : mesh_of(self).walls) {
    py::dict entry;
    entry["edge"] = edge_name(wall.edge);
    entry["face"] = face_name(wall.face);
    entry["first_height"] = wall.first_height;
    entry["first_heights"] = wall.first_heights;
    entry["growth"] = wall.growth;
    entry["thickness"] = wall.thickness > 0.0 ? py::object(py::float_(wall.thickness)) : py::none();
    entry["achieved_first_height"] =
        range(wall.achieved_min, wall.achieved_mean, wall.achieved_max);
    entry["height_error"] = wall.height_error;
    entry["achieved_growth"] = wall.achieved_growth;
    entry["achieved_thickness"] =
        range(wall.thickness_min, wall.thickness_mean, wall.thickness_max);
    entry["requested_layers"] = wall.until_isotropic ? py::object(py::str("isotropic"))
                                                     : py::object(py::int_(wall.requested_layers));
    entry["layers"] = wall.layers;
    entry["stops"] = wall.stops;
    entry["first_stops"] = first_stops(wall);
    entry["shortfalls"] = shortfalls(wall);
    list.append(entry);
  }
  return list;
}

const char* severity_name(Severity severity) {
  switch (severity) {
    case Severity::kInfo:
      return "info";
    case Severity::kWarning:
      return "warning";
    case Severity::kError:
      break;
  }
  return "error";
}

py::list diagnostics(const py::object& self) {
  py::list list;
  for (const Diagnostic& diagnostic : mesh_of(self).diagnostics) {
    py::dict entry;
    entry["severity"] = severity_name(diagnostic.severity);
    entry["code"] = diagnostic.code;
    entry["patch"] = diagnostic.patch.valid() ? py::object(py::int_(diagnostic.patch.value))
                                              : py::object(py::none());
    entry["layer"] = diagnostic.layer;
    entry["point"] =
        py::make_tuple(diagnostic.point.x(), diagnostic.point.y(), diagnostic.point.z());
    entry["text"] = diagnostic.sentence.english();
    entry["form"] = diagnostic.sentence.form();
    entry["values"] = values_of(diagnostic.sentence);
    list.append(entry);
  }
  return list;
}

py::dict figures(const py::object& self) {
  const Figures& f = mesh_of(self).figures;
  py::dict entry;
  entry["nodes"] = f.nodes;
  entry["quads"] = f.quads;
  entry["triangles"] = f.triangles;
  entry["quad_percent"] = f.quad_percent;
  entry["layer_quad_percent"] = f.layer_quad_percent;
  entry["core_quad_percent"] = f.core_quad_percent;
  entry["angles_45_135_percent"] = f.angles_45_135_percent;
  entry["angles_below_20_percent"] = f.angles_below_20_percent;
  entry["angles_above_160_percent"] = f.angles_above_160_percent;
  entry["min_angle"] = f.min_angle;
  entry["max_angle"] = f.max_angle;
  entry["inverted"] = f.inverted;
  return entry;
}

std::string describe(const MeshView& view) {
  return "<Mesh: " + std::to_string(view.result.nodes.size()) + " nodes, " +
         std::to_string(view.result.quads.size()) + " quads, " +
         std::to_string(view.result.triangles.size()) + " triangles>";
}

}  // namespace

MeshView::MeshView(MeshResult mesh)
    : result(std::move(mesh)),
      quad_face(numbers_from_one(result.quad_face)),
      triangle_face(numbers_from_one(result.triangle_face)) {}

void bind_result(py::module_& module) {
  py::class_<MeshView, std::shared_ptr<MeshView>>(
      module, "Mesh",
      "A finished mesh, frozen: its arrays are read-only views. Node indices count from 0.")
      .def_property_readonly("nodes", &points<&MeshResult::nodes>, "(n, 3) float64 [mm]")
      .def_property_readonly("quads", &ints<&MeshResult::quads>,
                             "(q, 4) int32, counter-clockwise against the outward normal")
      .def_property_readonly("triangles", &ints<&MeshResult::triangles>, "(t, 3) int32")
      .def_property_readonly("face_of_quad", &face_numbers<&MeshView::quad_face>,
                             "(q,) int32, number of the CAD face, from 1")
      .def_property_readonly("face_of_triangle", &face_numbers<&MeshView::triangle_face>,
                             "(t,) int32, number of the CAD face, from 1")
      .def_property_readonly("layer_of_quad", &ints<&MeshResult::quad_layer>, "(q,) int32, 0: core")
      .def_property_readonly("layer_of_triangle", &ints<&MeshResult::triangle_layer>,
                             "(t,) int32, 0: core")
      .def_property_readonly("node_parent", &ints<&MeshResult::node_parent>,
                             "(n,) int32, the node it was extruded from; -1: none")
      .def_property_readonly("node_layer", &ints<&MeshResult::node_layer>,
                             "(n,) int32, the layer it was extruded in; 0: boundary or core")
      .def_property_readonly(
          "periodic_nodes", [](const py::object& self) { return mesh_of(self).periodic_nodes; },
          "By entry of the settings' periodic: pairs (node, the one that its motion brings it "
          "onto)")
      .def_property_readonly("edge_segments", &of_edges<&MeshResult::edge_segments>,
                             "CAD edge number (from 1) -> (k, 2) int32, mesh edges in order")
      .def_property_readonly("mid_nodes", &points<&MeshResult::mid_nodes>,
                             "(m, 3) float64 [mm], at order 2; numbered on from len(nodes)")
      .def_property_readonly("mids_of_quad", &ints<&MeshResult::quad_mids>,
                             "(q, 4) int32 at order 2: between corners k and k + 1")
      .def_property_readonly("mids_of_triangle", &ints<&MeshResult::triangle_mids>,
                             "(t, 3) int32 at order 2")
      .def_property_readonly("mids_of_segment", &of_edges<&MeshResult::segment_mids>,
                             "CAD edge number -> (k,) int32 at order 2, beside edge_segments")
      .def_property_readonly("patches", &patches, "One dictionary per patch.")
      .def_property_readonly("walls", &walls,
                             "One dictionary per wall edge and face: asked and achieved.")
      .def_property_readonly("diagnostics", &diagnostics, "One dictionary per diagnostic.")
      .def_property_readonly("figures", &figures, "Quality figures, as in the report.")
      .def_property_readonly(
          "seconds", [](const MeshView& view) { return view.result.seconds; },
          "Wall-clock times: boundary, triangulate, layers, core.")
      .def("__repr__", &describe);
}

}  // namespace advlayers::python
