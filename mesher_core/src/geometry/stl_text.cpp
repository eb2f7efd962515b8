#include "geometry/stl_text.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/error.h"

namespace advlayers {
namespace {

using Triangle = std::array<Vec3, 3>;

constexpr std::size_t kHeader = 80, kCount = 4, kRecord = 50;  // [bytes]

class StlScanner {
 public:
  explicit StlScanner(std::string_view text) : text_(text) {}

  std::string_view word() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string_view line() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find('\n', at_), text_.size());
    return text_.substr(begin, at_ - begin);
  }

  void expect(const char* wanted) {
    if (!same(word(), wanted)) fail(wanted);
  }

  double real() {
    std::string_view text = word();
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0.0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // A number too small for a double is as good as null.
    if (error == std::errc::result_out_of_range && rest == text.data() + text.size()) return 0.0;
    if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value)) {
      fail("a number");
    }
    return value;
  }

  [[noreturn]] void fail(const char* missing) const {
    long line = 1;
    for (std::size_t i = 0; i < at_; ++i) line += text_[i] == '\n';
    throw InvalidInput("it is damaged: line {}: {} is missing", line, missing);
  }

  static bool same(std::string_view word, std::string_view wanted) {
    if (word.size() != wanted.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
      const char c = word[i];
      if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != wanted[i]) return false;
    }
    return true;
  }

 private:
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  std::string_view text_;
  std::size_t at_ = 0;
};

Triangle facet_of(StlScanner& in) {
  in.expect("normal");
  for (int i = 0; i < 3; ++i) in.word();  // some programs write "nan" here
  in.expect("outer");
  in.expect("loop");
  Triangle triangle;
  for (Vec3& corner : triangle) {
    in.expect("vertex");
    for (int i = 0; i < 3; ++i) corner[i] = in.real();
  }
  in.expect("endloop");
  in.expect("endfacet");
  return triangle;
}

std::vector<Triangle> triangles_of_text(const std::string& bytes) {
  StlScanner in(bytes);
  std::vector<Triangle> triangles;
  for (std::string_view word = in.word(); !word.empty(); word = in.word()) {
    if (!StlScanner::same(word, "solid")) in.fail("solid");
    in.line();  // its name
    for (word = in.word(); StlScanner::same(word, "facet"); word = in.word()) {
      triangles.push_back(facet_of(in));
    }
    if (!StlScanner::same(word, "endsolid")) in.fail("endsolid");
    in.line();
  }
  return triangles;
}

std::uint32_t count_of(const std::string& bytes) {
  std::uint32_t count = 0;
  if (bytes.size() >= kHeader + kCount) std::memcpy(&count, bytes.data() + kHeader, kCount);
  return count;
}

std::vector<Triangle> triangles_of_bytes(const std::string& bytes) {
  const std::size_t count = count_of(bytes);
  std::vector<Triangle> triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    float numbers[12];  // the normal's come first
    std::memcpy(numbers, bytes.data() + kHeader + kCount + kRecord * i, sizeof numbers);
    for (std::size_t k = 0; k < 9; ++k) {
      if (!std::isfinite(numbers[3 + k])) {
        throw InvalidInput("it is damaged: triangle {} has a corner that is nowhere", i + 1);
      }
      triangles[i][k / 3][static_cast<int>(k % 3)] = static_cast<double>(numbers[3 + k]);
    }
  }
  return triangles;
}

}  // namespace

std::vector<std::array<Vec3, 3>> stl_triangles(const std::string& bytes) {
  // A file of bytes may begin with the word "solid", too: its length tells.
  const std::size_t whole = kHeader + kCount + kRecord * static_cast<std::size_t>(count_of(bytes));
  if (bytes.size() >= kHeader + kCount && bytes.size() == whole) return triangles_of_bytes(bytes);
  const std::string_view first = StlScanner(bytes).word();
  const bool text = StlScanner::same(first, "solid") && bytes.find('\0') == std::string::npos;
  if (text) return triangles_of_text(bytes);
  if (bytes.size() < kHeader + kCount) throw InvalidInput("it is no STL file");
  throw InvalidInput("it is damaged: {} triangles take {} bytes, it has {}", count_of(bytes), whole,
                     bytes.size());
}

}  // namespace advlayers
