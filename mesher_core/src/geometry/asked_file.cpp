// What the program advlayers-read does: checks, the reader, the comparison.
#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>

#include "base/error.h"
#include "geometry/facet_shape.h"
#include "geometry/file_gate.h"
#include "geometry/file_kind.h"
#include "geometry/foreign_readers.h"
#include "geometry/iges_text.h"
#include "geometry/occt_shape.h"
#include "geometry/sew_shape.h"
#include "geometry/stl_text.h"
#include "geometry/torn_shape.h"

namespace advlayers {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TopoDS_Shape read_shape(FileKind kind, const std::string& path) {
  const std::string text = text_of(path);
  switch (kind) {
    case FileKind::kBrep:
      return is_binary_brep(text) ? shape_of_binary_brep(text) : shape_of_brep(RunContext(), text);
    case FileKind::kStep:
      return shape_of_step(path, StepText(text));
    case FileKind::kIges:
      check_iges_text(text);
      return shape_of_iges(path);
    default:
      return shape_of_triangles(stl_triangles(text));
  }
}

// Whatever the process that asks does with the text is done here first.
std::string read_and_try(FileKind kind, const std::string& path, double sew_tolerance) {
  const TopoDS_Shape shape = translated(kind_name(kind), [&] { return read_shape(kind, path); });
  if (shape.IsNull()) {
    throw InvalidInput("no shape could be read, it is no {} file or holds none", kind_name(kind));
  }
  refuse_torn_shape(shape);
  const std::string text = brep_of_shape(shape);
  auto again = std::make_unique<Model::Shape>();
  again->root = shape_of_brep(RunContext(), text);
  model_of_shape(RunContext(), std::move(again), sew_tolerance);
  return text;
}

}  // namespace

std::string brep_asked_for(const std::string& request) {
  const std::size_t end = request.find('\n');
  if (end == std::string::npos) throw InternalError("a reader was asked for nothing");
  const double sew_tolerance = std::strtod(request.c_str() + 1, nullptr);
  return read_and_try(static_cast<FileKind>(request[0] - '0'), request.substr(end + 1),
                      sew_tolerance);
}

}  // namespace advlayers
