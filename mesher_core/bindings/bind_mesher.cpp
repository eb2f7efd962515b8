#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "bindings.h"
#include "mesh_view.h"
#include "mesher/mesher.h"
#include "run_interruptibly.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

// Keeps context and model alive and remembers the result, which a Mesher gives only once.
struct MesherHandle {
  MesherHandle(std::shared_ptr<RunContext> the_context, std::shared_ptr<Model> the_model,
               const Settings& settings)
      : context(std::move(the_context)),
        model(std::move(the_model)),
        mesher(*context, *model, settings) {}

  std::shared_ptr<RunContext> context;
  std::shared_ptr<Model> model;
  Mesher mesher;
  std::shared_ptr<MeshView> result;
  std::mutex mutex;  // guards `result`
};

std::unique_ptr<MesherHandle> make_mesher(const std::shared_ptr<Model>& model,
                                          const Settings& settings,
                                          const std::shared_ptr<RunContext>& given) {
  const std::shared_ptr<RunContext> context = given_or_own(given);
  return run_interruptibly(
      *context, [&] { return std::make_unique<MesherHandle>(context, model, settings); });
}

LayerReport next_report(MesherHandle& self) {
  std::optional<LayerReport> report;
  if (self.mesher.ready()) {
    report = self.mesher.next();
  } else {
    report = run_interruptibly(*self.context, [&self] { return self.mesher.next(); });
  }
  if (!report) throw py::stop_iteration();
  return *report;
}

// Of several threads the first to come makes it, the others wait for it.
std::shared_ptr<MeshView> result_of(MesherHandle& self) {
  return run_interruptibly(*self.context, [&self] {
    const std::lock_guard<std::mutex> lock(self.mutex);
    if (!self.result) self.result = std::make_shared<MeshView>(self.mesher.result());
    return self.result;
  });
}

std::shared_ptr<MeshView> snapshot_of(const MesherHandle& self) {
  const py::gil_scoped_release release;
  return std::make_shared<MeshView>(self.mesher.snapshot());
}

template <class Id, std::size_t kCount>
py::dict counted(const std::array<int, kCount>& counts,
                 const std::array<Named<Id>, kCount>& names) {
  py::dict named;
  for (const auto& [id, name] : names) {
    const int count = counts[static_cast<std::size_t>(id)];
    if (count > 0) named[name] = count;
  }
  return named;
}

std::string describe(const LayerReport& report) {
  return "<LayerReport: patch " + std::to_string(report.patch.value) + ", layer " +
         std::to_string(report.layer) + ", " + std::to_string(report.quads) + " quads, " +
         std::to_string(report.triangles) + " triangles, " + std::to_string(report.front_vertices) +
         " front vertices>";
}

void bind_report(py::module_& module) {
  py::class_<LayerReport>(module, "LayerReport", "One layer of one patch.")
      .def_property_readonly(
          "patch", [](const LayerReport& r) { return r.patch.value; },
          "Index into Mesh.patches, from 0.")
      .def_readonly("layer", &LayerReport::layer, "From 1.")
      .def_readonly("front_vertices", &LayerReport::front_vertices, "After the layer.")
      .def_readonly("quads", &LayerReport::quads, "Made in this layer.")
      .def_readonly("triangles", &LayerReport::triangles, "Made in this layer.")
      .def_property_readonly(
          "vetoes", [](const LayerReport& r) { return counted(r.vetoes, kVetoes); },
          "Why local operations were refused -> how often.")
      .def_property_readonly(
          "events", [](const LayerReport& r) { return counted(r.events, kEvents); },
          "Why the front lost edges -> how often.")
      .def_property_readonly(
          "stops", [](const LayerReport& r) { return counted(r.stops, kStops); },
          "Why front vertices got no further kid -> how many.")
      .def("__repr__", &describe);
}

}  // namespace

void bind_mesher(py::module_& module) {
  bind_report(module);
  py::class_<MesherHandle>(
      module, "Mesher",
      "Mesher(model, settings, context=None) -> iterator of LayerReport, one per layer and\n"
      "patch.\n\n"
      "The caller owns the loop and may stop after any layer. The global interpreter lock is\n"
      "released while it works. The same input gives the same mesh for any number of threads.\n\n"
      "Raises InvalidInput naming a wrong setting; Cancelled from the loop and from result() "
      "after\n"
      "cancel(); KeyboardInterrupt.")
      .def(py::init(&make_mesher), py::arg("model").none(false), py::arg("settings").none(false),
           py::arg("context") = py::none())
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &next_report)
      .def(
          "cancel", [](MesherHandle& self) { self.context->cancel(); },
          "RunContext.cancel() of the mesher's context: stops the work, for good.")
      .def("snapshot", &snapshot_of,
           "The Mesh as it stands, before result(); its walls and figures are not measured.\n\n"
           "Raises Cancelled where cancel() comes meanwhile; after it, the mesh is still there.")
      .def("result", &result_of,
           "Finishes the core and gives the Mesh; the same object every time.\n\n"
           "Runs the loop where it was not begun; where it was, the layers so far are kept.");
}

}  // namespace advlayers::python
