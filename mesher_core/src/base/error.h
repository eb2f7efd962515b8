// The four kinds of error. Messages name the thing and its value.
#pragma once

#include <stdexcept>
#include <string>

#include "base/sentence.h"

namespace advlayers {

// What an error has to say, for windows in other languages; what() is the same in English.
class Told {
 public:
  const Sentence& sentence() const { return sentence_; }

 protected:
  explicit Told(Sentence sentence) : sentence_(std::move(sentence)) {}
  ~Told() = default;

 private:
  Sentence sentence_;
};

// The caller's fault: a setting, a name, a file that is not there. ValueError in Python.
class InvalidInput : public std::invalid_argument, public Told {
 public:
  explicit InvalidInput(Sentence sentence)
      : std::invalid_argument(sentence.english()), Told(std::move(sentence)) {}
  template <class... Values>
  explicit InvalidInput(const std::string& form, const Values&... values)
      : InvalidInput(Sentence(form, values...)) {}
};

// The shape's fault: nothing in it that could be meshed. RuntimeError in Python.
class GeometryError : public std::runtime_error, public Told {
 public:
  explicit GeometryError(Sentence sentence)
      : std::runtime_error(sentence.english()), Told(std::move(sentence)) {}
  template <class... Values>
  explicit GeometryError(const std::string& form, const Values&... values)
      : GeometryError(Sentence(form, values...)) {}
};

// A stop that was asked for.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("meshing was cancelled") {}
};

// Our fault. RuntimeError in Python.
class InternalError : public std::logic_error, public Told {
 public:
  explicit InternalError(const std::string& what)
      : InternalError(Sentence("{} (internal error: please report it with the model)", what)) {}

 private:
  explicit InternalError(Sentence sentence)
      : std::logic_error(sentence.english()), Told(std::move(sentence)) {}
};

}  // namespace advlayers
