// Not a test: the tests read files with the reader of their own build.
#include "geometry/file_gate.h"

namespace advlayers {
namespace {

[[maybe_unused]] const bool told = (set_reader_program(READER_PROGRAM), true);

}  // namespace
}  // namespace advlayers
