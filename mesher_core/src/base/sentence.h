// A sentence for the user as a form and its values, so that it can be said in other languages.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace advlayers {

// What the user is told: an English form, with a {} for each of its values. A window may say the
// form in another language: docs/make_translations.py finds the literals that Sentences are made
// of.
class Sentence {
 public:
  Sentence() = default;
  template <class... Values>
  explicit Sentence(std::string form, const Values&... values)
      : form_(std::move(form)), values_{shown(values)...} {}

  const std::string& form() const { return form_; }
  const std::vector<std::string>& values() const { return values_; }
  std::string english() const;

  // The same form about something else.
  template <class... Values>
  Sentence about(const Values&... values) const {
    return Sentence(form_, values...);
  }

  // Puts what `make` makes of each value into its place.
  template <class Make>
  void change(const Make& make) {
    for (std::string& value : values_) value = make(value);
  }

 private:
  template <class Value>
  static std::string shown(const Value& value) {
    std::ostringstream text;
    text << value;
    return text.str();
  }

  std::string form_;
  std::vector<std::string> values_;
};

}  // namespace advlayers
