#include <exception>
#include <utility>

#include "base/error.h"
#include "bindings.h"
#include "sentence_values.h"

namespace py = pybind11;

namespace advlayers::python {
namespace {

// The Python class of an error; it lives as long as the module, which is never unloaded.
template <class Error>
py::handle& python_class() {
  static py::handle kind;
  return kind;
}

void raise(const py::handle& kind, const std::string& what, const Sentence& sentence) {
  const py::object error = kind(text_of(what));
  error.attr("form") = text_of(sentence.form());
  error.attr("values") = values_of(sentence);
  PyErr_SetObject(kind.ptr(), error.ptr());
}

// An error whose Python class also has the form and the values of what it says.
template <class Error>
void bind_told(py::module_& module, const char* name, PyObject* base, const char* doc) {
  py::exception<Error> kind(module, name, base);
  kind.doc() = doc;
  python_class<Error>() = kind.release();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const Error& error) {
      raise(python_class<Error>(), error.what(), error.sentence());
    }
  });
}

}  // namespace

void bind_errors(py::module_& module) {
  bind_told<InvalidInput>(module, "InvalidInput", PyExc_ValueError,
                          "The caller's fault: a setting, a name, a file that is not there.");
  bind_told<GeometryError>(module, "GeometryError", PyExc_RuntimeError,
                           "The shape's fault: nothing in it that could be meshed.");
  bind_told<InternalError>(module, "InternalError", PyExc_RuntimeError,
                           "A fault of this library: please report it with the model.");
  py::register_exception<Cancelled>(module, "Cancelled", PyExc_Exception).doc() =
      "A stop that was asked for with RunContext.cancel() or Mesher.cancel().";
}

}  // namespace advlayers::python
