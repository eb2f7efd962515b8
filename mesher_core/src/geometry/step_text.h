// What stands in a STEP file (ISO 10303-21), by its text alone, before any reader is let at it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace advlayers {

// Throws InvalidInput, with the line or the entity and what is wrong there, unless the text is
// whole: every entity well-formed and given once; whatever the shapes need is there; and each face,
// bound, loop, oriented edge, shell and solid is part of something.
class StepText {
 public:
  explicit StepText(const std::string& text);

  // Whether a shape is made of the entity, by way of others or not at all.
  bool needed(std::int64_t id) const;
  std::size_t faces() const { return faces_; }  // that the shapes are made of

 private:
  enum class Kind : std::uint8_t { kOther, kPart, kFace, kShape };
  struct Entity {
    std::int64_t id = 0;
    std::string_view type;  // of several, the first
    Kind kind = Kind::kOther;
    bool needed = false, used = false;
    std::size_t references = 0;  // where their number is in references_; they follow
  };

  void read_statement(std::string_view statement);
  void read_entity(std::string_view statement);
  void read_parameters(std::string_view statement, std::size_t begin, Entity& entity);
  static Kind kind_of(std::string_view type);
  Entity* find(std::int64_t id);
  std::size_t references_end(const Entity& entity) const;
  void mark_used();
  void mark_needed();
  void refuse_lost_parts() const;
  [[noreturn]] void refuse(std::string_view at, const char* what) const;

  const std::string& text_;
  std::vector<Entity> entities_;  // by id, once all are read
  std::vector<std::int64_t> references_;
  bool in_data_ = false, data_ended_ = false;
  std::size_t faces_ = 0;
};

}  // namespace advlayers
