// A sentence's form and values for Python, which may say them in another language.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "base/sentence.h"

namespace advlayers::python {

// Of bytes that are no UTF-8 too: OpenCASCADE quotes what stands in a file.
pybind11::str text_of(const std::string& text);

// A list of texts; a value that is itself a sentence is a dictionary of its form and values.
pybind11::list values_of(const Sentence& sentence);

}  // namespace advlayers::python
