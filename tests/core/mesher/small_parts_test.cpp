// Edges and faces far smaller than the elements: meshed with what fits, and told of.
#include "mesher/small_parts.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>

#include <algorithm>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

std::string told(const MeshResult& mesh, const std::string& code) {
  std::string text;
  for (const Diagnostic& d : mesh.diagnostics) {
    if (d.code != code) continue;
    EXPECT_TRUE(text.empty()) << "said twice: " << d.sentence.english();
    EXPECT_EQ(d.severity, Severity::kInfo);
    text = d.sentence.english();
  }
  return text;
}

// One block stands out by 0.02 over the other, which leaves strips and edges of that width.
TEST(SmallParts, StripsAreMeshedInOneRowAndNamed) {
  const Model model =
      model_of(BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(10, 10, 4).Shape(),
                                BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), gp_Pnt(16, 10, 4.02)).Shape())
                   .Shape());
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 2;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_EQ(mesh.figures.inverted, 0);
  expect_watertight(mesh);
  const std::string edges = told(mesh, "tiny-edges"), faces = told(mesh, "sliver-faces");
  std::size_t tiny = 0, slivers = 0;
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].length > 0.03) continue;
    ++tiny;
    EXPECT_NE(edges.find(edge_name(EdgeId(e)) + " (0.02 mm)"), std::string::npos) << edges;
    EXPECT_EQ(mesh.edge_segments[e].size(), 1u);
  }
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    if (model.faces()[f].area > 0.3) continue;
    ++slivers;
    EXPECT_NE(faces.find(face_name(FaceId(f)) + " (0.0"), std::string::npos) << faces;
    // One row: as many elements as the long side has mesh edges.
    std::size_t longest = 0;
    for (const CoEdge& side : model.faces()[f].loops[0]) {
      longest = std::max(longest, mesh.edge_segments[side.edge.index()].size());
    }
    const auto on_it = std::count(mesh.quad_face.begin(), mesh.quad_face.end(), FaceId(f)) +
                       std::count(mesh.triangle_face.begin(), mesh.triangle_face.end(), FaceId(f));
    EXPECT_EQ(static_cast<std::size_t>(on_it), longest);
  }
  EXPECT_EQ(tiny, 2u);
  EXPECT_EQ(slivers, 1u);
}

TEST(SmallParts, ThereAreNoneInAPlainShape) {
  Settings settings = test::coarse_settings();
  settings.size = 1.0;
  settings.first_height = 0.1;
  const MeshResult mesh = mesh_of(model_of(rectangle(10, 6)), settings);
  EXPECT_EQ(told(mesh, "tiny-edges") + told(mesh, "sliver-faces"), "");
}

}  // namespace
}  // namespace advlayers::test
