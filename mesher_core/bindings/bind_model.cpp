#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <string>

#include "base/error.h"
#include "bindings.h"
#include "geometry/evaluator.h"
#include "geometry/face_boxes.h"
#include "geometry/file_gate.h"
#include "geometry/model.h"
#include "geometry/solids.h"
#include "run_interruptibly.h"
#include "setting_values.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

double tolerance_of(const py::object& value) {
  const double tolerance = number(value, "sew_tolerance");
  if (tolerance >= 0.0) return tolerance;
  throw InvalidInput("sew_tolerance must be >= 0 mm, got " + shown(value));
}

std::shared_ptr<Model> model_of_text(const std::string& text, const py::object& sew_tolerance,
                                     const std::shared_ptr<RunContext>& given) {
  const double tolerance = tolerance_of(sew_tolerance);
  const std::shared_ptr<RunContext> context = given_or_own(given);
  return run_interruptibly(
      *context, [&] { return std::make_shared<Model>(read_brep(*context, text, tolerance)); });
}

// As the system has it: a name that is no text is one too.
std::string name_of(const py::object& path) {
  return py::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

std::shared_ptr<Model> model_of_file(const py::object& path, const py::object& sew_tolerance,
                                     const std::shared_ptr<RunContext>& given) {
  const std::string name = name_of(path);
  const double tolerance = tolerance_of(sew_tolerance);
  const std::shared_ptr<RunContext> context = given_or_own(given);
  return run_interruptibly(
      *context, [&] { return std::make_shared<Model>(read_file(*context, name, tolerance)); });
}

py::str text_of_file(const py::object& path, const py::object& sew_tolerance,
                     const std::shared_ptr<RunContext>& given) {
  const std::string name = name_of(path);
  const double tolerance = tolerance_of(sew_tolerance);
  const std::shared_ptr<RunContext> context = given_or_own(given);
  return run_interruptibly(*context, [&] { return brep_of_file(*context, name, tolerance); });
}

std::vector<std::vector<int>> solids(const Model& model) {
  std::vector<std::vector<int>> all;
  for (const auto& faces : solids_of(model)) {
    std::vector<int>& numbers = all.emplace_back();
    for (const FaceId face : faces) numbers.push_back(face.value + 1);
  }
  return all;
}

py::list boxes(const Model& model) {
  py::list corners;
  for (const Box& box : face_boxes(model)) {
    if (box.isEmpty()) {
      corners.append(py::none());
      continue;
    }
    const auto row = [](const Vec3& xyz) { return py::make_tuple(xyz.x(), xyz.y(), xyz.z()); };
    corners.append(py::make_tuple(row(box.min()), row(box.max())));
  }
  return corners;
}

// The inner loops of plane faces: face, edges, and the diameter of a circle as long.
py::list holes(const Model& model) {
  py::list all;
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    const Face& face = model.faces()[f];
    if (face.kind != SurfaceKind::kPlane) continue;
    for (std::size_t i = 1; i < face.loops.size(); ++i) {
      py::list edges;
      double length = 0.0;
      for (const CoEdge& coedge : face.loops[i]) {
        edges.append(edge_name(coedge.edge));
        length += model.edge(coedge.edge).length;
      }
      all.append(py::make_tuple(face_name(FaceId(f)), edges, length / M_PI));
    }
  }
  return all;
}

// [deg] by edge; none where there are not two sides.
py::list dihedral_angles(const Model& model) {
  py::list all;
  for (std::size_t e = 0; e < model.given_edges(); ++e) {
    const double angle = model.dihedral_angle(EdgeId(e));
    const bool known = angle < M_PI && !model.edge(EdgeId(e)).degenerate;
    all.append(known ? py::object(py::float_(angle * 180.0 / M_PI)) : py::object(py::none()));
  }
  return all;
}

using Points = py::array_t<double, py::array::c_style | py::array::forcecast>;

Points project(const Model& model, int number, const Points& points) {
  if (number < 1 || static_cast<std::size_t>(number) > model.faces().size()) {
    throw InvalidInput("{}: there is no {}, faces of the model: {}", "face",
                       face_name(FaceId(number - 1)), model.faces().size());
  }
  if (points.ndim() != 2 || points.shape(1) != 3) {
    throw InvalidInput("points must be an array of rows of three numbers");
  }
  Points feet(std::vector<py::ssize_t>{points.shape(0), 3});
  const auto given = points.unchecked<2>();
  auto found = feet.mutable_unchecked<2>();
  const py::gil_scoped_release release;
  Evaluator evaluator(model);
  for (py::ssize_t i = 0; i < given.shape(0); ++i) {
    const Vec3 xyz(given(i, 0), given(i, 1), given(i, 2));
    const Vec3 foot = evaluator.closest(FaceId(number - 1), xyz).xyz;
    for (py::ssize_t k = 0; k < 3; ++k) found(i, k) = foot[k];
  }
  return feet;
}

std::string describe(const Model& model) {
  return "<Model: " + std::to_string(model.faces().size()) + " faces, " +
         std::to_string(model.given_edges()) + " edges, " +
         std::to_string(model.vertices().size()) + " vertices>";
}

}  // namespace

void bind_model(py::module_& module) {
  py::class_<Model, std::shared_ptr<Model>>(
      module, "Model",
      "A BRep, read once; made by read_brep() or read_file(). Faces, edges and vertices are\n"
      "numbered from 1, as FreeCAD numbers them.")
      .def_property_readonly("face_count", [](const Model& m) { return m.faces().size(); })
      .def_property_readonly("edge_count", &Model::given_edges)
      .def_property_readonly("vertex_count", [](const Model& m) { return m.vertices().size(); })
      .def_property_readonly("diagonal", &Model::diagonal, "Diagonal of the bounding box [mm].")
      .def_property_readonly("closed", &Model::closed,
                             "Whether every edge of a face is used by exactly two face sides.")
      .def_property_readonly("solids", &solids,
                             "The numbers of the faces around each solid, those of cavities too.")
      .def_property_readonly("face_boxes", &boxes,
                             "By face the least and the greatest corner of a box that holds it "
                             "[mm]; None for a face without a surface.")
      .def_property_readonly(
          "holes", &holes,
          "The inner loops of plane faces: (\"Face1\", [\"Edge3\"], the diameter "
          "[mm] of a circle as long).")
      .def_property_readonly("dihedral_angles", &dihedral_angles,
                             "The angle [deg] between the two face sides at each edge; None where "
                             "there are not two.")
      .def("project", &project, py::arg("face"), py::arg("points"),
           "The point of a face, by number from 1, that is nearest to each of the points (n, 3)\n"
           "[mm]. Raises InvalidInput for a face that is not there.")
      .def("__repr__", &describe);
  module.def(
      "read_brep", &model_of_text, py::arg("text"), py::arg("sew_tolerance") = 0.0,
      py::arg("context") = py::none(),
      "Reads BREP text, as FreeCAD's Shape.exportBrepToString() gives it. Faces whose edges\n"
      "lie within sew_tolerance [mm] of each other are joined there; 0: none are.\n\n"
      "Raises InvalidInput if the text is no BREP, GeometryError if it holds no face.");
  module.def(
      "brep_of_file", &text_of_file, py::arg("path"), py::arg("sew_tolerance") = 0.0,
      py::arg("context") = py::none(),
      "BREP text of what .step .stp .iges .igs .brep .brp .stl files hold, by the ending in\n"
      "any case; in mm. The file is read in a child process, so that one that crashes\n"
      "OpenCASCADE's readers, or keeps them busy without end, is an error; so is one of\n"
      "which not everything arrives. What read_brep() makes of the text with the same\n"
      "sew_tolerance was tried there, too.\n\n"
      "Raises InvalidInput for a missing, damaged or unreadable file, GeometryError if it\n"
      "holds no face, Cancelled.");
  module.def("read_file", &model_of_file, py::arg("path"), py::arg("sew_tolerance") = 0.0,
             py::arg("context") = py::none(),
             "read_brep(brep_of_file(path, sew_tolerance), sew_tolerance).");
}

}  // namespace advlayers::python
