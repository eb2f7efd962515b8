#include "geometry/iges_text.h"

#include <charconv>
#include <map>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace advlayers {
namespace {

constexpr std::size_t kLetter = 72;  // the column of a section's letter
constexpr std::size_t kField = 8;    // columns of a field of a directory entry

using Sections = std::map<char, std::vector<std::string_view>>;

Sections sections_of(std::string_view text) {
  Sections sections;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.size() > kLetter) sections[line[kLetter]].push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return sections;
}

// -1: there is no whole number.
long number_in(std::string_view field) {
  while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
  long number = 0;
  const auto [rest, error] = std::from_chars(field.data(), field.data() + field.size(), number);
  return error == std::errc() && rest != field.data() ? number : -1;
}

long field_of(std::string_view line, std::size_t index) {
  return number_in(line.substr(index * kField, kField));
}

void check_counts(const Sections& sections) {
  const auto ends = sections.find('T');
  if (ends == sections.end()) throw InvalidInput("it is cut off: its last line is missing");
  const std::string_view last = ends->second.back();
  for (std::size_t field = 0; field < 4; ++field) {
    const char letter = last[field * kField];
    const long promised = number_in(last.substr(field * kField + 1, kField - 1));
    const auto found = sections.find(letter);
    const long counted = found == sections.end() ? 0 : static_cast<long>(found->second.size());
    if (promised < 0 || promised > counted) {
      throw InvalidInput("it is damaged: of the lines {} it has {}, its last line says {}", letter,
                         counted, promised);
    }
  }
}

// An entry has two lines of ten fields; both begin with the type.
void check_directory(const std::vector<std::string_view>& lines,
                     const std::vector<std::string_view>& parameters) {
  if (lines.size() % 2 != 0) throw InvalidInput("it is damaged: an entry has lost a line");
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    const long type = field_of(lines[i], 0), place = field_of(lines[i], 1);
    const auto count = static_cast<long>(parameters.size());
    if (type < 0 || type != field_of(lines[i + 1], 0)) {
      throw InvalidInput("it is damaged: the entry D{} has no type", i + 1);
    }
    if (type == 0) continue;  // an entity that was deleted
    const bool there = place >= 1 && place <= count;
    if (!there ||
        number_in(parameters[static_cast<std::size_t>(place - 1)].substr(0, kLetter)) != type) {
      throw InvalidInput("it is damaged: the entry D{} has no parameters of its type {}", i + 1,
                         type);
    }
  }
}

}  // namespace

void check_iges_text(const std::string& text) {
  const Sections sections = sections_of(text);
  if (sections.count('S') == 0) throw InvalidInput("it is no IGES file: its first line is missing");
  if (sections.count('C') != 0) return;
  check_counts(sections);
  const auto directory = sections.find('D'), parameters = sections.find('P');
  if (directory == sections.end() || parameters == sections.end()) {
    throw InvalidInput("it is damaged: it holds no entity");
  }
  check_directory(directory->second, parameters->second);
}

}  // namespace advlayers
