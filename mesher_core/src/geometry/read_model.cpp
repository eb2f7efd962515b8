#include "geometry/file_gate.h"
#include "geometry/foreign_readers.h"
#include "geometry/occt_shape.h"
#include "geometry/sew_shape.h"

namespace advlayers {

Model model_of_shape(const RunContext& context, std::unique_ptr<Model::Shape> shape,
                     double sew_tolerance) {
  if (sew_tolerance > 0.0) sew_shape(context, *shape, sew_tolerance);
  return build_model(context, std::move(shape));
}

Model read_brep(const RunContext& context, const std::string& text, double sew_tolerance) {
  const StageScope stage(context, RunStage::kRead);
  auto shape = std::make_unique<Model::Shape>();
  {
    const std::lock_guard<std::mutex> lock(reader_mutex());
    shape->root = shape_of_brep(context, text);
  }
  if (shape->root.IsNull()) throw InvalidInput("the text is no BREP shape");
  return model_of_shape(context, std::move(shape), sew_tolerance);
}

Model read_file(const RunContext& context, const std::string& path, double sew_tolerance) {
  return read_brep(context, brep_of_file(context, path, sew_tolerance), sew_tolerance);
}

}  // namespace advlayers
