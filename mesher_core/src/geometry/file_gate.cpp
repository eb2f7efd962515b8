#include "geometry/file_gate.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>

#include "base/child_process.h"
#include "base/error.h"
#include "geometry/facet_shape.h"
#include "geometry/foreign_readers.h"
#include "geometry/iges_text.h"
#include "geometry/occt_shape.h"
#include "geometry/sew_shape.h"
#include "geometry/stl_text.h"
#include "geometry/torn_shape.h"

namespace advlayers {
namespace {

// What sound files of all kinds take, ten times over: 0.5 s and 30 MB for each MB.
constexpr double kSeconds = 20.0, kSecondsPerByte = 5e-6;
constexpr std::size_t kBytes = std::size_t{1} << 30, kBytesPerByte = 300;

enum class Kind { kBrep, kStep, kIges, kStl };

std::string ending_of(const std::string& path) {
  const std::size_t dot = path.find_last_of('.');
  const std::size_t slash = path.find_last_of("/\\");
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
  std::string ending = path.substr(dot + 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

Kind kind_of(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == "brep" || ending == "brp") return Kind::kBrep;
  if (ending == "step" || ending == "stp") return Kind::kStep;
  if (ending == "iges" || ending == "igs") return Kind::kIges;
  if (ending == "stl") return Kind::kStl;
  throw InvalidInput("{}: the ending is none of {}", path, ".step .stp .iges .igs .brep .brp .stl");
}

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::kBrep:
      return "BREP";
    case Kind::kStep:
      return "STEP";
    case Kind::kIges:
      return "IGES";
    default:
      return "STL";
  }
}

std::size_t size_of(const std::string& path) {
  std::error_code trouble;
  const bool regular = std::filesystem::is_regular_file(path, trouble);
  const auto size = regular ? std::filesystem::file_size(path, trouble) : 0;
  if (!regular || trouble || !std::ifstream(path, std::ios::binary)) {
    throw InvalidInput("{}: the file cannot be opened", path);
  }
  return static_cast<std::size_t>(size);
}

ChildLimits limits_of(std::size_t size) {
  ChildLimits limits;
  limits.seconds = kSeconds + kSecondsPerByte * static_cast<double>(size);
  limits.bytes = std::min(kBytes + kBytesPerByte * size, machine_bytes());
  return limits;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TopoDS_Shape read_shape(Kind kind, const std::string& path) {
  const std::string text = text_of(path);
  switch (kind) {
    case Kind::kBrep:
      return is_binary_brep(text) ? shape_of_binary_brep(text) : shape_of_brep(RunContext(), text);
    case Kind::kStep:
      return shape_of_step(path, StepText(text));
    case Kind::kIges:
      check_iges_text(text);
      return shape_of_iges(path);
    default:
      return shape_of_triangles(stl_triangles(text));
  }
}

// Whatever the process that asks does with the text is done here first.
std::string read_and_try(Kind kind, const std::string& path, double sew_tolerance) {
  const TopoDS_Shape shape = translated(name_of(kind), [&] { return read_shape(kind, path); });
  if (shape.IsNull()) {
    throw InvalidInput("no shape could be read, it is no {} file or holds none", name_of(kind));
  }
  refuse_torn_shape(shape);
  const std::string text = brep_of_shape(shape);
  auto again = std::make_unique<Model::Shape>();
  again->root = shape_of_brep(RunContext(), text);
  model_of_shape(RunContext(), std::move(again), sew_tolerance);
  return text;
}

InvalidInput refusal(const std::string& path, Kind kind, const ChildFailed& failure,
                     const ChildLimits& limits) {
  switch (failure.why()) {
    case ChildFailed::Why::kCrashed:
      return InvalidInput("{}: the {} file is damaged: its reader crashes on it ({})", path,
                          name_of(kind), failure.what());
    case ChildFailed::Why::kTooSlow:
      return InvalidInput("{}: reading the {} file does not end within {} s", path, name_of(kind),
                          static_cast<long>(limits.seconds));
    case ChildFailed::Why::kTooLarge:
      return InvalidInput("{}: reading the {} file takes more than {} MB", path, name_of(kind),
                          limits.bytes >> 20);
    default:
      return InvalidInput("{}: no process can be started to read it: {}", path, failure.what());
  }
}

// What the child is asked: kind, tolerance and name of a file.
std::string request_of(Kind kind, const std::string& path, double sew_tolerance) {
  char tolerance[32];
  std::snprintf(tolerance, sizeof tolerance, "%a", sew_tolerance);
  return std::string(1, static_cast<char>('0' + static_cast<int>(kind))) + tolerance + '\n' + path;
}

std::string& given_program() {
  static std::string program;
  return program;
}

std::mutex& program_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string reader_program() {
  const std::lock_guard<std::mutex> lock(program_mutex());
  return given_program().empty() ? own_folder() + "/advlayers-read" : given_program();
}

}  // namespace

void set_reader_program(const std::string& path) {
  const std::lock_guard<std::mutex> lock(program_mutex());
  given_program() = path;
}

std::string brep_asked_for(const std::string& request) {
  const std::size_t end = request.find('\n');
  if (end == std::string::npos) throw InternalError("a reader was asked for nothing");
  const double sew_tolerance = std::strtod(request.c_str() + 1, nullptr);
  return read_and_try(static_cast<Kind>(request[0] - '0'), request.substr(end + 1), sew_tolerance);
}

std::string brep_of_file(const RunContext& context, const std::string& path, double sew_tolerance) {
  const StageScope stage(context, RunStage::kRead);
  const Kind kind = kind_of(path);
  const ChildLimits limits = limits_of(size_of(path));
  try {
    return answer_of_child({reader_program()}, request_of(kind, path, sew_tolerance), limits,
                           [&context] { context.check(); });
  } catch (const ChildFailed& failure) {
    throw refusal(path, kind, failure, limits);
  } catch (const InvalidInput& error) {
    throw InvalidInput("{}: {}", path, error.sentence());
  } catch (const GeometryError& error) {
    throw GeometryError("{}: {}", path, error.sentence());
  }
}

}  // namespace advlayers
