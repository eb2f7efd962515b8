#include "geometry/file_gate.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mutex>

#include "base/child_process.h"
#include "base/error.h"
#include "geometry/file_kind.h"

namespace advlayers {
namespace {

// What sound files of all kinds take, ten times over: 0.5 s and 30 MB for each MB.
constexpr double kSeconds = 20.0, kSecondsPerByte = 5e-6;
constexpr std::size_t kBytes = std::size_t{1} << 30, kBytesPerByte = 300;

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

InvalidInput refusal(const std::string& path, FileKind kind, const ChildFailed& failure,
                     const ChildLimits& limits) {
  switch (failure.why()) {
    case ChildFailed::Why::kCrashed:
      return InvalidInput("{}: the {} file is damaged: its reader crashes on it ({})", path,
                          kind_name(kind), failure.what());
    case ChildFailed::Why::kTooSlow:
      return InvalidInput("{}: reading the {} file does not end within {} s", path, kind_name(kind),
                          static_cast<long>(limits.seconds));
    case ChildFailed::Why::kTooLarge:
      return InvalidInput("{}: reading the {} file takes more than {} MB", path, kind_name(kind),
                          limits.bytes >> 20);
    default:
      return InvalidInput("{}: no process can be started to read it: {}", path, failure.what());
  }
}

// What the child is asked: kind, tolerance and name of a file.
std::string request_of(FileKind kind, const std::string& path, double sew_tolerance) {
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

std::string brep_of_file(const RunContext& context, const std::string& path, double sew_tolerance) {
  const StageScope stage(context, RunStage::kRead);
  const FileKind kind = file_kind(path);
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
