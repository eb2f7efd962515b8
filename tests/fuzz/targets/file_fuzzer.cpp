// libFuzzer on our own checks of CAD files; what passes them goes on through the whole gate. Built
// once for each kind: FUZZED_ENDING. Of errors, only those that tell the user are allowed.
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/error.h"
#include "geometry/brep_text.h"
#include "geometry/file_gate.h"
#include "geometry/file_kind.h"
#include "geometry/iges_text.h"
#include "geometry/step_text.h"
#include "geometry/stl_text.h"

namespace {

using namespace advlayers;

const std::string kEnding = FUZZED_ENDING;

std::string scratch_file() {
  static const std::string path = (std::filesystem::temp_directory_path() /
                                   ("advlayers-fuzz-" + std::to_string(getpid()) + kEnding))
                                      .string();
  static const int registered = std::atexit([] { std::filesystem::remove(path); });
  return registered == 0 ? path : "";
}

bool passes(FileKind kind, const std::string& text) {
  try {
    switch (kind) {
      case FileKind::kBrep:
        check_brep_text(text);
        break;
      case FileKind::kStep:
        return StepText(text).faces() > 0;
      case FileKind::kIges:
        check_iges_text(text);
        break;
      default:
        return !stl_triangles(text).empty();
    }
    return true;
  } catch (const InvalidInput&) {
    return false;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (!passes(file_kind(kEnding), text)) return 0;
  const std::string path = scratch_file();
  std::ofstream(path, std::ios::binary) << text;
  set_reader_program(READER_PROGRAM);
  try {
    brep_of_file(RunContext(), path, 0.0);
  } catch (const InvalidInput&) {
  } catch (const GeometryError&) {
  }
  return 0;
}
