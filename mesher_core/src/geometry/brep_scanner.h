// Numbers and words of a text, one after the other, with the line for the message.
#pragma once

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "base/error.h"

namespace advlayers {

class BrepScanner {
 public:
  BrepScanner(const std::string& text, std::size_t begin)
      : text_(&text), at_(text.data() + begin), end_(text.data() + text.size()) {}

  [[noreturn]] void fail(const std::string& what) const {
    long line = 1;
    for (const char* p = text_->data(); p < at_; ++p) line += *p == '\n';
    throw InvalidInput("the text is no BREP shape: line {}: {}", line, what);
  }

  void expect(bool holds, const char* what) const {
    if (!holds) fail(what);
  }

  double real() {
    skip_space();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    const bool whole = rest == end_ || is_space(*rest);
    expect(error == std::errc() && whole && std::isfinite(value), "a number is missing");
    at_ = rest;
    return value;
  }

  void reals(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) real();
  }

  int integer(int least, int most, const char* what) {
    skip_space();
    int value = 0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    // The name of a continuity may follow at once: "4C2".
    const bool whole = rest == end_ || is_space(*rest) || *rest == 'C' || *rest == 'G';
    expect(error == std::errc() && whole && value >= least && value <= most, what);
    at_ = rest;
    return value;
  }

  // No list is longer than the text that is left.
  int count(int least = 0) {
    const auto left = std::min<std::ptrdiff_t>(end_ - at_, std::numeric_limits<int>::max());
    return integer(least, static_cast<int>(left), "a count is wrong");
  }

  bool flag() { return integer(0, 1, "a flag is neither 0 nor 1") == 1; }

  std::string word() {
    skip_space();
    const char* begin = at_;
    while (at_ < end_ && !is_space(*at_)) ++at_;
    return {begin, at_};
  }

  char letter() {
    skip_space();
    expect(at_ < end_, "the text is cut off");
    return *at_++;
  }

  std::string peek_word() {
    const char* here = at_;
    std::string next = word();
    at_ = here;
    return next;
  }

  void keyword(const char* name) {
    if (word() != name) fail(std::string("the table ") + name + " is missing");
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  void skip_space() {
    while (at_ < end_ && is_space(*at_)) ++at_;
  }

  const std::string* text_;
  const char* at_;
  const char* end_;
};

}  // namespace advlayers
