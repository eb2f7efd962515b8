#include "bindings.h"
#include "geometry/model.h"
#include "mesher/estimate.h"
#include "run_interruptibly.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

py::dict estimate_of(const std::shared_ptr<Model>& model, const Settings& settings,
                     const std::shared_ptr<RunContext>& given) {
  const std::shared_ptr<RunContext> context = given_or_own(given);
  const Estimate found =
      run_interruptibly(*context, [&] { return estimate(*context, *model, settings); });
  py::dict values;
  values["elements"] = found.elements;
  values["megabytes"] = found.megabytes;
  values["seconds"] = found.seconds;
  values["driver"] = found.driver;
  return values;
}

}  // namespace

void bind_estimate(py::module_& module) {
  module.def(
      "estimate", &estimate_of, py::arg("model").none(false), py::arg("settings").none(false),
      py::arg("context") = py::none(),
      "What a mesh will take, within a factor of some three, before anything is made:\n"
      "\"elements\", \"megabytes\" of memory, \"seconds\" of computing on one processor, and\n"
      "\"driver\", the key of the setting that most of the elements are for.");
}

}  // namespace advlayers::python
