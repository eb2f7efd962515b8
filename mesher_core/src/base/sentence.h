// A sentence for the user as a form and its values, so that it can be said in other languages.
#pragma once

#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace advlayers {

// What the user is told: an English form, with a {} for each of its values. A value may itself be
// something to be said: a reason, a rule. A window may say the forms in another language:
// docs/make_translations.py finds the literals that Sentences, and errors, are made of.
class Sentence {
 public:
  struct Value;

  Sentence() = default;
  template <class... Values>
  explicit Sentence(std::string form, const Values&... values) : form_(std::move(form)) {
    values_.reserve(sizeof...(values));
    (values_.push_back(shown(values)), ...);
  }

  bool empty() const { return form_.empty(); }
  const std::string& form() const { return form_; }
  const std::vector<Value>& values() const { return values_; }
  std::string english() const;

  // The same form about something else.
  template <class... Values>
  Sentence about(const Values&... values) const {
    return Sentence(form_, values...);
  }

  // Puts what `make` makes of each text among the values into its place.
  template <class Make>
  void change(const Make& make);

 private:
  template <class Shown>
  static Value shown(const Shown& value);

  std::string form_;
  std::vector<Value> values_;
};

struct Sentence::Value {
  std::string text;  // as it is in every language; where there is no sentence
  Sentence sentence;

  std::string english() const { return sentence.empty() ? text : sentence.english(); }
};

template <class Make>
void Sentence::change(const Make& make) {
  for (Value& value : values_) {
    if (value.sentence.empty()) {
      value.text = make(value.text);
    } else {
      value.sentence.change(make);
    }
  }
}

template <class Shown>
Sentence::Value Sentence::shown(const Shown& value) {
  if constexpr (std::is_same_v<Shown, Sentence>) {
    return {{}, value};
  } else {
    std::ostringstream text;
    text << value;
    return {text.str(), {}};
  }
}

}  // namespace advlayers
