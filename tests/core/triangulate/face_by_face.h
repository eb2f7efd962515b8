// A shape whose faces are meshed one by one, or together, and held to what every patch has to
// fulfil.
#pragma once

#include <vector>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "triangulate/cut_edges.h"
#include "triangulate/mesh_properties.h"

namespace advlayers::test {

struct FaceByFace {
  explicit FaceByFace(const TopoDS_Shape& shape, double size)
      : model(model_of(shape)), evaluator(model) {
    settings.size = size;
    cut = cut_edges(evaluator, size, settings.curvature_angle);
  }

  Triangulation mesh(FaceId face) { return mesh(std::vector<FaceId>{face}); }
  Triangulation mesh(const std::vector<FaceId>& faces) {
    PatchSurface surface(evaluator, faces, settings.feature_angle);
    return triangulate(RunContext(), surface, evaluator, cut, settings);
  }

  // All faces as one patch.
  void expect_as_one(int euler, const Expected& expected = {}) {
    std::vector<FaceId> faces;
    for (std::size_t i = 0; i < model.faces().size(); ++i) faces.push_back(FaceId(i));
    PatchSurface surface(evaluator, faces, settings.feature_angle);
    const Triangulation made = triangulate(RunContext(), surface, evaluator, cut, settings);
    EXPECT_TRUE(made.diagnostics.empty());
    expect_sound(made, surface, evaluator, cut, settings, euler, expected);
  }

  // Euler numbers by face.
  void expect(const std::vector<int>& euler, const Expected& expected = {}) {
    ASSERT_EQ(model.faces().size(), euler.size());
    for (std::size_t i = 0; i < euler.size(); ++i) {
      SCOPED_TRACE(face_name(FaceId(i)));
      PatchSurface surface(evaluator, {FaceId(i)});
      const Triangulation made = triangulate(RunContext(), surface, evaluator, cut, settings);
      EXPECT_TRUE(made.diagnostics.empty());
      expect_sound(made, surface, evaluator, cut, settings, euler[i], expected);
    }
  }

  Model model;
  Evaluator evaluator;
  Settings settings = test::coarse_settings();
  Discretization cut;
};

}  // namespace advlayers::test
