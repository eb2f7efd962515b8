#include "mesher/tight_faces.h"

#include "mesher/small_parts.h"
#include "sizing/size_field.h"

namespace advlayers {
namespace {

constexpr double kNarrow = 0.25;  // width over size
constexpr double kTurn = 0.6;     // [rad] across the width
constexpr int kSamples = 3;       // per direction

bool turns(Evaluator& evaluator, FaceId id, double width) {
  const Face& face = evaluator.model().face(id);
  if (face.kind == SurfaceKind::kPlane) return false;
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      const double u = face.u_min + (face.u_max - face.u_min) * (i + 0.5) / kSamples;
      const double v = face.v_min + (face.v_max - face.v_min) * (j + 0.5) / kSamples;
      if (evaluator.max_curvature(id, u, v) * width > kTurn) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<FaceId> tight_faces(const RunContext& context, Evaluator& evaluator,
                                const Settings& settings) {
  const Model& model = evaluator.model();
  const SizeField sizes(settings);
  std::vector<FaceId> found;
  for (std::size_t i = 0; i < model.faces().size(); ++i) {
    context.check();
    const FaceId face(i);
    if (!model.face(face).defect.empty()) continue;
    const double width = width_of(model, face);
    if (width < kNarrow * sizes.of_face(face) && turns(evaluator, face, width)) {
      found.push_back(face);
    }
  }
  return found;
}

}  // namespace advlayers
