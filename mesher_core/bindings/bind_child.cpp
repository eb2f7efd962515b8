#include <pybind11/functional.h>
#include <unistd.h>

#include <new>

#include "bindings.h"
#include "geometry/child_process.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

// What the interpreter does before and after a copy is made, on both sides.
class Fork {
 public:
  Fork() : parent_(getpid()) { PyOS_BeforeFork(); }
  ~Fork() { done(); }
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  void done() {
    if (done_) return;
    done_ = true;
    getpid() == parent_ ? PyOS_AfterFork_Parent() : PyOS_AfterFork_Child();
  }

 private:
  pid_t parent_;
  bool done_ = false;
};

py::bytes result_in_child(const py::function& act, double seconds, double megabytes) {
  const ChildLimits limits{seconds, static_cast<std::size_t>(megabytes) << 20};
  Fork fork;
  const auto in_copy = [&]() -> std::string {
    fork.done();
    try {
      return act().cast<std::string>();
    } catch (const py::error_already_set& error) {
      if (error.matches(PyExc_MemoryError)) throw std::bad_alloc();
      throw;
    }
  };
  const auto poll = [&fork] {
    fork.done();
    const py::gil_scoped_release others_may_go_on;
    const py::gil_scoped_acquire again;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  return in_child(limits, in_copy, poll);
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
  module.def("in_child", &result_in_child, py::arg("act"), py::arg("seconds"), py::arg("megabytes"),
             "The bytes that act() returns in a copy of this process, which may compute for so\n"
             "long and take so much memory beyond what is in use: what crashes or never ends\n"
             "does so there. Raises ChildFailed.");
}

}  // namespace advlayers::python
