#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <new>

#include "base/child_process.h"
#include "bindings.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

py::bytes answer_of_program(const std::vector<std::string>& command, const std::string& request,
                            double seconds, double megabytes) {
  ChildLimits limits;
  limits.seconds = seconds;
  limits.bytes = static_cast<std::size_t>(megabytes) << 20;
  const py::gil_scoped_release others_may_go_on;
  const std::string answer = answer_of_child(command, request, limits, [] {
    const py::gil_scoped_acquire again;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  });
  const py::gil_scoped_acquire again;
  return answer;
}

void answer(const py::function& act) {
  answer_parent([&act](const std::string& request) -> std::string {
    try {
      return act(py::bytes(request)).cast<std::string>();
    } catch (const py::error_already_set& error) {
      if (error.matches(PyExc_MemoryError)) throw std::bad_alloc();
      throw;
    }
  });
}

}  // namespace

void bind_child(py::module_& module) {
  static py::exception<ChildFailed> failed(module, "ChildFailed", PyExc_RuntimeError);
  failed.doc() =
      "What was done in a child process crashed, passed its limits, or could not be begun:\n"
      "`reason` is \"crashed\", \"seconds\", \"megabytes\" or \"not started\".";
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const ChildFailed& error) {
      static constexpr const char* kReasons[] = {"crashed", "seconds", "megabytes", "not started"};
      const py::object raised = py::handle(failed)(error.what());
      raised.attr("reason") = kReasons[static_cast<int>(error.why())];
      PyErr_SetObject(failed.ptr(), raised.ptr());
    }
  });
  module.def("answer_of_child", &answer_of_program, py::arg("command"), py::arg("request"),
             py::arg("seconds"), py::arg("megabytes"),
             "The bytes that the program answers, which may compute for so long and take so much\n"
             "memory beyond its start. Raises ChildFailed.");
  module.def("answer_parent", &answer, py::arg("act"),
             "In a program that answer_of_child() has started: ends it with the bytes that\n"
             "act(request) returns.");
}

}  // namespace advlayers::python
