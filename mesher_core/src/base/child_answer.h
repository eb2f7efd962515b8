// What a child process has to say to its parent, as bytes.
#pragma once

#include <string>

#include "base/sentence.h"

namespace advlayers {

std::string answer_of_result(const std::string& result);
std::string answer_of_invalid_input(const Sentence& sentence);
std::string answer_of_geometry_error(const Sentence& sentence);
std::string answer_out_of_memory();

// Whatever was printed before an answer is left out.
//
// The result; throws the error that was answered instead. Throws ChildFailed where memory ran out,
// and where the bytes are no whole answer.
std::string result_of_answer(const std::string& answer);

}  // namespace advlayers
