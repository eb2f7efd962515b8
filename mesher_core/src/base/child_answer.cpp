#include "base/child_answer.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/child_process.h"
#include "base/error.h"

namespace advlayers {
namespace {

constexpr char kResult = 'r', kInvalid = 'i', kGeometry = 'g', kMemory = 'm';
constexpr char kEnd = '.';  // a child that died while writing leaves it out
// No program prints this by itself before it answers.
constexpr char kBegin[] =
    "\x1f"
    "advlayers answers\x1f";

// A text is a sentence without values, which no language has another form of.
using Values = std::array<Sentence, 8>;

template <std::size_t... I>
Sentence filled(const std::string& form, const Values& values, std::index_sequence<I...>) {
  return Sentence(form, values[I]...);
}

Sentence with_values(const std::string& form, const Values& values, std::size_t count) {
  switch (count) {
    case 0:
      return Sentence(form);
    case 1:
      return filled(form, values, std::make_index_sequence<1>());
    case 2:
      return filled(form, values, std::make_index_sequence<2>());
    case 3:
      return filled(form, values, std::make_index_sequence<3>());
    default:  // those left over have no place in the form
      return filled(form, values, std::make_index_sequence<8>());
  }
}

void put(std::string& bytes, const std::string& text) {
  const auto size = static_cast<std::uint64_t>(text.size());
  bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes += text;
}

void put(std::string& bytes, const Sentence& sentence) {
  put(bytes, sentence.form());
  bytes += static_cast<char>(sentence.values().size());
  for (const Sentence::Value& value : sentence.values()) {
    bytes += value.sentence.empty() ? 't' : 's';
    if (value.sentence.empty()) {
      put(bytes, value.text);
    } else {
      put(bytes, value.sentence);
    }
  }
}

std::string answer(char kind, const Sentence& sentence) {
  std::string bytes = std::string(kBegin) + kind;
  put(bytes, sentence);
  return bytes + kEnd;
}

class Answer {
 public:
  Answer(const std::string& bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  char letter() { return *take(1); }

  std::string text() {
    std::uint64_t size = 0;
    std::memcpy(&size, take(sizeof size), sizeof size);
    return {take(size), static_cast<std::size_t>(size)};
  }

  Sentence sentence() {
    const std::string form = text();
    Values values;
    const auto count = static_cast<std::size_t>(letter());
    for (std::size_t i = 0; i < count && i < values.size(); ++i) {
      values[i] = letter() == 's' ? sentence() : Sentence(text());
    }
    return with_values(form, values, count);
  }

 private:
  const char* take(std::uint64_t size) {
    if (size > bytes_.size() - at_) {
      throw ChildFailed(ChildFailed::Why::kCrashed, "its answer is cut off");
    }
    const char* here = bytes_.data() + at_;
    at_ += size;
    return here;
  }

  const std::string& bytes_;
  std::size_t at_;
};

}  // namespace

std::string answer_of_result(const std::string& result) {
  std::string bytes = std::string(kBegin) + kResult;
  put(bytes, result);
  return bytes + kEnd;
}

std::string answer_of_invalid_input(const Sentence& sentence) { return answer(kInvalid, sentence); }
std::string answer_of_geometry_error(const Sentence& sentence) {
  return answer(kGeometry, sentence);
}
std::string answer_out_of_memory() { return std::string(kBegin) + kMemory + kEnd; }

std::string result_of_answer(const std::string& answer) {
  const std::size_t begin = answer.find(kBegin);
  if (begin == std::string::npos || answer.back() != kEnd) {
    throw ChildFailed(ChildFailed::Why::kCrashed, "it ended without an answer");
  }
  Answer read(answer, begin + std::strlen(kBegin));
  switch (read.letter()) {
    case kResult:
      return read.text();
    case kInvalid:
      throw InvalidInput(read.sentence());
    case kGeometry:
      throw GeometryError(read.sentence());
    default:
      throw ChildFailed(ChildFailed::Why::kTooLarge, "it ran out of memory");
  }
}

}  // namespace advlayers
