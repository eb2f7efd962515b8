#include <pybind11/stl.h>

#include <memory>
#include <string>

#include "base/run_context.h"
#include "bindings.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

py::tuple progress(const RunContext& context) {
  const Progress progress = context.progress();
  return py::make_tuple(stage_name(progress.stage), progress.share);
}

py::dict seconds(const RunContext& context) {
  py::dict by_stage;
  for (std::size_t k = 1; k < kRunStages; ++k) {
    const auto stage = static_cast<RunStage>(k);
    by_stage[stage_name(stage)] = context.seconds(stage);
  }
  return by_stage;
}

std::string describe(const RunContext& context) {
  return std::string("<RunContext: ") + stage_name(context.progress().stage) +
         (context.cancelled() ? ", cancelled>" : ">");
}

}  // namespace

void bind_context(py::module_& module) {
  py::class_<RunContext, std::shared_ptr<RunContext>>(
      module, "RunContext",
      "What a run shares with its caller: made for one run, before its file is read, and handed\n"
      "to read_file(), read_brep() and Mesher. May be used from any thread.")
      .def(py::init([] { return std::make_shared<RunContext>(); }))
      .def("cancel", &RunContext::cancel,
           "Stops the run, for good: what is at work raises Cancelled within a tenth of a second\n"
           "(OpenCASCADE's readers may take longer).")
      .def_property_readonly("cancelled", &RunContext::cancelled)
      .def_property_readonly(
          "progress", &progress,
          "(stage, share): \"read\", \"boundary\", \"triangulate\", \"layers\" or\n"
          "\"core\", \"\" before the first, and how much of it is done, 0 to 1.")
      .def_property_readonly("seconds", &seconds, "Wall-clock time of each stage so far.")
      .def("__repr__", &describe);
}

}  // namespace advlayers::python
