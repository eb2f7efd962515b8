// Every face of the models in a folder: set ADVLAYERS_MODELS to it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/error.h"
#include "boundary/halve_edges.h"
#include "coarse_settings.h"
#include "triangulate/mesh_properties.h"

namespace advlayers {
namespace {

namespace fs = std::filesystem;
using namespace test;

constexpr int kHalvings = 4;

Triangulation triangulate_halving(PatchSurface& surface, Evaluator& evaluator,
                                  const Settings& settings, Discretization& cut) {
  for (int round = 0;; ++round) {
    try {
      return triangulate(RunContext(), surface, evaluator, cut, settings);
    } catch (const BoundaryTooCoarse& error) {
      if (round == kHalvings) throw;
      halve_edges(RunContext(), evaluator, error.edges(), cut);
    }
  }
}

TEST(TriangulateModels, EveryFaceBecomesAManifold) {
  const char* folder = std::getenv("ADVLAYERS_MODELS");
  if (!folder) GTEST_SKIP() << "ADVLAYERS_MODELS names no folder";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".step" && ending != ".stp" && ending != ".iges" && ending != ".brep") continue;
    SCOPED_TRACE(entry.path().filename().string());
    const Model model = read_file(RunContext(), entry.path().string());
    Evaluator evaluator(model);
    Settings settings = test::coarse_settings();
    settings.size = 0.02 * model.diagonal();
    settings.first_height = 0.1 * settings.size;
    Discretization cut = discretize(RunContext(), evaluator, settings);
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      if (!model.faces()[f].defect.empty()) continue;
      SCOPED_TRACE(face_name(FaceId(f)));
      PatchSurface surface(evaluator, {FaceId(f)});
      const Triangulation made = triangulate_halving(surface, evaluator, settings, cut);
      EXPECT_EQ(find_connectivity_fault(made.mesh), "");
      expect_border_kept(made.mesh, evaluator, cut, surface.faces(), settings.feature_angle);
      EXPECT_NEAR(area_of(made.mesh), model.faces()[f].area, 0.1 * model.faces()[f].area);
      // Nothing that is turned over or leans too far goes unreported.
      EXPECT_TRUE(!made.diagnostics.empty() || find_inverted_element(made.mesh).empty());
    }
  }
}

}  // namespace
}  // namespace advlayers
