#include "geometry/step_text.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/error.h"

namespace advlayers {
namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

// Behind a text in quotes (where a quote stands twice) or a comment that begins at `i`, or i.
std::size_t behind_quoted(std::string_view text, std::size_t i) {
  if (text[i] == '\'' || text[i] == '"') return text.find(text[i], i + 1);
  if (text.compare(i, 2, "/*") != 0) return i;
  const std::size_t end = text.find("*/", i + 2);
  return end == std::string_view::npos ? end : end + 1;
}

// Takes comments away from the front as well.
std::string_view without_comments(std::string_view text) {
  text = trimmed(text);
  while (text.compare(0, 2, "/*") == 0) {
    const std::size_t end = text.find("*/", 2);
    text = end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end + 2));
  }
  return text;
}

std::int64_t number_at(std::string_view text, std::size_t i, std::size_t& end) {
  std::int64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data() + i, text.data() + text.size(), number);
  end = static_cast<std::size_t>(rest - text.data());
  return error == std::errc() && is_digit(text[i]) ? number : -1;
}

std::string_view word_at(std::string_view text, std::size_t i) {
  std::size_t end = i;
  while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
  return text.substr(i, end - i);
}

bool is_one_of(std::string_view type, const std::array<const char*, 12>& types) {
  return std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

StepText::StepText(const std::string& text) : text_(text) {
  const std::string_view all(text);
  if (all.substr(0, 4096).find("ISO-10303-21") == std::string_view::npos) {
    throw InvalidInput("it is no STEP file: it lacks the line {}", "ISO-10303-21;");
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    i = behind_quoted(all, i);
    if (i == std::string_view::npos) break;
    if (all[i] != ';') continue;
    const std::string_view statement = without_comments(all.substr(begin, i - begin));
    if (statement == "END-ISO-10303-21") break;
    read_statement(statement);
    begin = i + 1;
  }
  if (!data_ended_) throw InvalidInput("it is cut off: it lacks the line {}", "ENDSEC;");
  std::stable_sort(entities_.begin(), entities_.end(),
                   [](const Entity& a, const Entity& b) { return a.id < b.id; });
  mark_used();
  mark_needed();
  refuse_lost_parts();
}

bool StepText::needed(std::int64_t id) const {
  const Entity* entity = const_cast<StepText*>(this)->find(id);
  return entity && entity->needed;
}

void StepText::read_statement(std::string_view statement) {
  if (in_data_ && statement != "ENDSEC") return read_entity(statement);
  if (in_data_) data_ended_ = true;
  in_data_ = !in_data_ && word_at(statement, 0) == "DATA";
  if (in_data_) data_ended_ = false;  // a file may have several sections of data
}

void StepText::read_entity(std::string_view statement) {
  std::size_t i = 0;
  Entity entity;
  entity.id = statement.size() > 1 && statement[0] == '#' ? number_at(statement, 1, i) : -1;
  while (i < statement.size() && is_space(statement[i])) ++i;
  if (entity.id < 0 || i == statement.size() || statement[i] != '=') {
    refuse(statement, "this is no entity");
  }
  entity.references = references_.size();
  references_.push_back(0);  // their number
  read_parameters(statement, i + 1, entity);
  if (entity.type.empty()) refuse(statement, "an entity has no type");
  references_[entity.references] =
      static_cast<std::int64_t>(references_.size() - entity.references - 1);
  entities_.push_back(entity);
}

void StepText::read_parameters(std::string_view statement, std::size_t begin, Entity& entity) {
  int depth = 0;
  const std::size_t first = statement.find_first_not_of(" \t\r\n", begin);
  const int of_types = first != std::string_view::npos && statement[first] == '(' ? 1 : 0;
  for (std::size_t i = begin; i < statement.size(); ++i) {
    i = behind_quoted(statement, i);
    if (i == std::string_view::npos) refuse(statement, "a text does not end");
    const char c = statement[i];
    if (c == '(') ++depth;
    if (c == ')' && --depth < 0) refuse(statement, "brackets do not match");
    if (c == '#') {
      std::size_t end = i;
      references_.push_back(i + 1 < statement.size() ? number_at(statement, i + 1, end) : -1);
      if (references_.back() < 0) refuse(statement, "a reference lacks its number");
      i = end - 1;
    } else if (is_letter(c) && depth == of_types) {
      const std::string_view type = word_at(statement, i);
      entity.kind = std::max(entity.kind, kind_of(type));
      if (entity.type.empty()) entity.type = type;
      i += type.size() - 1;
    }
  }
  if (depth != 0) refuse(statement, "brackets do not match");
}

StepText::Kind StepText::kind_of(std::string_view type) {
  static constexpr std::array<const char*, 12> kParts{
      "FACE_BOUND",  "FACE_OUTER_BOUND", "EDGE_LOOP",           "POLY_LOOP",
      "VERTEX_LOOP", "ORIENTED_EDGE",    "CLOSED_SHELL",        "OPEN_SHELL",
      "MAPPED_ITEM", "FACETED_BREP",     "MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS"};
  if (type == "ADVANCED_FACE" || type == "FACE_SURFACE") return Kind::kFace;
  if (is_one_of(type, kParts)) return Kind::kPart;
  const bool shape = type.find("SHAPE_") != std::string_view::npos &&
                     type.find("REPRESENTATION") != std::string_view::npos;
  const bool dimension = type.find("DIMENSION") != std::string_view::npos;
  return shape && !dimension ? Kind::kShape : Kind::kOther;
}

StepText::Entity* StepText::find(std::int64_t id) {
  const auto found = std::lower_bound(entities_.begin(), entities_.end(), id,
                                      [](const Entity& a, std::int64_t b) { return a.id < b; });
  return found != entities_.end() && found->id == id ? &*found : nullptr;
}

std::size_t StepText::references_end(const Entity& entity) const {
  return entity.references + static_cast<std::size_t>(references_[entity.references]) + 1;
}

void StepText::mark_used() {
  for (const Entity& entity : entities_) {
    for (std::size_t i = entity.references + 1; i < references_end(entity); ++i) {
      if (Entity* used = find(references_[i])) used->used = true;
    }
  }
}

// A depth-first walk that visits each entity once.
void StepText::mark_needed() {
  std::vector<Entity*> open;
  for (Entity& entity : entities_) {
    if (entity.kind == Kind::kShape) open.push_back(&entity);
  }
  while (!open.empty()) {
    Entity& entity = *open.back();
    open.pop_back();
    if (entity.needed) continue;
    entity.needed = true;
    faces_ += entity.kind == Kind::kFace;
    for (std::size_t i = entity.references + 1; i < references_end(entity); ++i) {
      Entity* next = find(references_[i]);
      if (!next) {
        throw InvalidInput("it is damaged: #{} ({}) refers to #{}, which is not there", entity.id,
                           entity.type, references_[i]);
      }
      if (!next->needed) open.push_back(next);
    }
  }
}

void StepText::refuse_lost_parts() const {
  for (std::size_t i = 0; i < entities_.size(); ++i) {
    const Entity& entity = entities_[i];
    if (i > 0 && entities_[i - 1].id == entity.id) {
      throw InvalidInput("it is damaged: #{} is given twice", entity.id);
    }
    if ((entity.kind == Kind::kPart || entity.kind == Kind::kFace) && !entity.used) {
      throw InvalidInput("it is damaged: #{} ({}) is part of nothing", entity.id, entity.type);
    }
  }
}

void StepText::refuse(std::string_view at, const char* what) const {
  const auto begin = text_.begin();
  const auto lines = std::count(begin, begin + (at.data() - text_.data()), '\n');
  throw InvalidInput("it is damaged: line {}: {}", lines + 1, Sentence(what));
}

}  // namespace advlayers
