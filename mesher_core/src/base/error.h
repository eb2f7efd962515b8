// The four kinds of error. Messages name the thing and its value.
#pragma once

#include <stdexcept>
#include <string>

namespace advlayers {

// The caller's fault: a setting, a name, a file that is not there. ValueError in Python.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

// The shape's fault: nothing in it that could be meshed. RuntimeError in Python.
class GeometryError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A stop that was asked for.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("meshing was cancelled") {}
};

// Our fault. RuntimeError in Python.
class InternalError : public std::logic_error {
 public:
  explicit InternalError(const std::string& what)
      : std::logic_error(what + " (internal error: please report it with the model)") {}
};

}  // namespace advlayers
