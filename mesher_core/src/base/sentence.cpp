#include "base/sentence.h"

namespace advlayers {

std::string Sentence::english() const {
  std::string text;
  std::size_t from = 0;
  for (const Value& value : values_) {
    const std::size_t place = form_.find("{}", from);
    if (place == std::string::npos) break;
    text += form_.substr(from, place - from) + value.english();
    from = place + 2;
  }
  return text + form_.substr(from);
}

}  // namespace advlayers
