#include "base/number_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr int kMost = 400;  // characters of a double in fixed notation, and of a field

template <class Number>
Number at(const NumberColumn& column, std::size_t row) {
  Number number;
  std::memcpy(
      &number,
      static_cast<const char*>(column.first) + static_cast<std::ptrdiff_t>(row) * column.stride,
      sizeof number);
  return number;
}

// "0.5" to ".5", "-0.5" to "-.5"; a point where there is none.
std::string plain(const char* begin, const char* end) {
  std::string text(begin, end);
  const std::size_t sign = text[0] == '-' ? 1 : 0;
  if (text.find('.') == std::string::npos) text += '.';
  if (text.size() > sign + 2 && text[sign] == '0') text.erase(sign, 1);
  return text;
}

// "1.5e-07" to "1.5E-7", "1e+20" to "1.E20".
std::string scientific(const char* begin, const char* end) {
  const std::string text(begin, end);
  const std::size_t e = text.find('e');
  std::string mantissa = text.substr(0, e);
  if (mantissa.find('.') == std::string::npos) mantissa += '.';
  return mantissa + 'E' + std::to_string(std::stoi(text.substr(e + 1)));
}

std::string shortest(double value, std::chars_format format) {
  char buffer[kMost];
  const char* end = std::to_chars(buffer, buffer + kMost, value, format).ptr;
  return format == std::chars_format::fixed ? plain(buffer, end) : scientific(buffer, end);
}

// The most places with which the number is no longer than `width`; empty: there are none.
std::string longest(double value, std::chars_format format, int width) {
  char buffer[kMost];
  for (int places = width - 1; places >= 0; --places) {
    const char* end = std::to_chars(buffer, buffer + kMost, value, format, places).ptr;
    std::string text =
        format == std::chars_format::fixed ? plain(buffer, end) : scientific(buffer, end);
    const int over = static_cast<int>(text.size()) - width;
    if (over <= 0) return text;
    places -= over - 1;
  }
  return {};
}

// For what fixed notation suits best, and most coordinates are: the same as fitted(), at once.
// Empty: the number is none of these.
std::string fitted_at_once(double value, int width) {
  const double size = std::abs(value);
  if (!(size >= 1e-3 && size < 1e6)) return {};
  int whole = 0;  // digits before the point
  for (double power = 1.0; power <= size; power *= 10.0) ++whole;
  const int places = width - whole - 1 - (value < 0.0 ? 1 : 0);
  char buffer[kMost];
  char* end = std::to_chars(buffer, buffer + kMost, value, std::chars_format::fixed, places).ptr;
  while (end[-1] == '0') --end;
  std::string text = plain(buffer, end);
  // Rounding may have made a digit more.
  return text.size() <= static_cast<std::size_t>(width) ? text : std::string();
}

double value_of(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

void append_padded(std::string& text, const char* begin, const char* end, int width) {
  const auto length = end - begin;
  if (length < width) text.append(static_cast<std::size_t>(width - length), ' ');
  text.append(begin, end);
}

// "%25.16E" and the like, from its percent sign; moves `at` behind it.
int digits(std::string_view form, std::size_t& at) {
  int number = 0;
  while (at < form.size() && form[at] >= '0' && form[at] <= '9' && number < kMost) {
    number = 10 * number + (form[at++] - '0');
  }
  return number;
}

}  // namespace

std::int64_t NumberColumn::integer(std::size_t row) const {
  return type == Type::Int32 ? at<std::int32_t>(*this, row) : at<std::int64_t>(*this, row);
}

double NumberColumn::real(std::size_t row) const { return at<double>(*this, row); }

std::string fitted(double value, int width) {
  if (std::string text = fitted_at_once(value, width); !text.empty()) return text;
  const std::size_t room = static_cast<std::size_t>(width);
  for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
    // The shortest fixed form of a huge number is its exact integer: as good, if it fits.
    std::string text = shortest(value, format);
    if (text.size() <= room) return text;
  }
  const std::string fixed = longest(value, std::chars_format::fixed, width);
  const std::string power = longest(value, std::chars_format::scientific, width);
  if (fixed.empty() || power.empty()) return fixed.empty() ? power : fixed;
  const bool nearer = std::abs(value_of(fixed) - value) <= std::abs(value_of(power) - value);
  return nearer ? fixed : power;
}

RowForm::RowForm(std::string_view form) {
  Piece text;
  for (std::size_t at = 0; at < form.size();) {
    if (form[at] != '%') {
      text.text += form[at++];
      continue;
    }
    Piece piece;
    piece.width = digits(form, ++at);
    if (at < form.size() && form[at] == '.') piece.places = digits(form, ++at);
    piece.kind = at < form.size() ? form[at++] : '\0';
    if (piece.kind == '%') {
      text.text += '%';
      continue;
    }
    const bool known = piece.kind != '\0' && std::strchr("dErw", piece.kind) != nullptr;
    const bool roomy = piece.kind != 'w' || piece.width >= 9;
    if (!known || !roomy || piece.width >= kMost || piece.places > 40) {
      throw InternalError("a form of rows cannot be read: " + std::string(form));
    }
    if (!text.text.empty()) pieces_.push_back(std::exchange(text, {}));
    pieces_.push_back(piece);
  }
  if (!text.text.empty()) pieces_.push_back(text);
}

void RowForm::check(const std::vector<NumberColumn>& columns) const {
  std::size_t next = 0;
  for (const Piece& piece : pieces_) {
    if (piece.kind == 't') continue;
    if (next == columns.size()) throw InternalError("a form of rows has more numbers than columns");
    const bool real = columns[next].type == NumberColumn::Type::Double;
    if (real != (piece.kind != 'd')) {
      throw InternalError("a form of rows has a number of another type than column " +
                          std::to_string(next));
    }
    ++next;
  }
  if (next != columns.size()) throw InternalError("a form of rows has fewer numbers than columns");
}

void RowForm::append(const std::vector<NumberColumn>& columns, std::size_t count,
                     std::string& text) const {
  check(columns);
  char buffer[kMost];
  for (std::size_t row = 0; row < count; ++row) {
    auto column = columns.begin();
    for (const Piece& piece : pieces_) {
      if (piece.kind == 't') {
        text += piece.text;
      } else if (piece.kind == 'd') {
        const char* end = std::to_chars(buffer, buffer + kMost, (column++)->integer(row)).ptr;
        append_padded(text, buffer, end, piece.width);
      } else if (piece.kind == 'w') {
        const std::string number = fitted((column++)->real(row), piece.width);
        text += number;
        text.append(static_cast<std::size_t>(piece.width) - number.size(), ' ');
      } else if (piece.kind == 'E') {
        char* end = std::to_chars(buffer, buffer + kMost, (column++)->real(row),
                                  std::chars_format::scientific, piece.places)
                        .ptr;
        std::replace(buffer, end, 'e', 'E');
        append_padded(text, buffer, end, piece.width);
      } else {
        const char* end = std::to_chars(buffer, buffer + kMost, (column++)->real(row)).ptr;
        append_padded(text, buffer, end, piece.width);
      }
    }
  }
}

}  // namespace advlayers
