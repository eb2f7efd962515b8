#include "sentence_values.h"

namespace py = pybind11;

namespace advlayers::python {

py::str text_of(const std::string& text) {
  const auto size = static_cast<py::ssize_t>(text.size());
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(text.data(), size, "replace"));
}

py::list values_of(const Sentence& sentence) {
  py::list list;
  for (const Sentence::Value& value : sentence.values()) {
    if (value.sentence.empty()) {
      list.append(text_of(value.text));
      continue;
    }
    py::dict said;
    said["form"] = text_of(value.sentence.form());
    said["values"] = values_of(value.sentence);
    list.append(said);
  }
  return list;
}

}  // namespace advlayers::python
