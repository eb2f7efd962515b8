// Rows of numbers as text in fixed columns, as mesh files have them: some thirty times as fast as
// Python.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace advlayers {

// One number of each row, `stride` bytes apart.
struct NumberColumn {
  enum class Type { Int32, Int64, Double };
  const void* first = nullptr;
  std::ptrdiff_t stride = 0;
  Type type = Type::Double;

  std::int64_t integer(std::size_t row) const;  // of an integer type
  double real(std::size_t row) const;
};

// What stands in a row, from a form like "%10d %25.16E\n": text, and numbers as
//   %d %10d     an integer, right-aligned in as many characters
//   %25.16E     a double in scientific notation with as many places, right-aligned
//   %r          a double in the fewest digits that bring it back exactly
//   %16w        a double in at most that many characters, always with a point, with the most digits
//               that fit; padded on the right
//   %%          a percent sign
class RowForm {
 public:
  // Throws InternalError for a form that is none of these.
  explicit RowForm(std::string_view form);

  // Appends `count` rows; throws InternalError where the columns do not fit the form.
  void append(const std::vector<NumberColumn>& columns, std::size_t count, std::string& text) const;

 private:
  struct Piece {
    char kind = 't';  // t: text, d, E, r, w
    int width = 0, places = 0;
    std::string text;
  };
  void check(const std::vector<NumberColumn>& columns) const;

  std::vector<Piece> pieces_;
};

// The double in at most `width` characters (at least 9), with a point: the most digits that fit.
std::string fitted(double value, int width);

}  // namespace advlayers
