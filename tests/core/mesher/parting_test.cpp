// Faces that the mesh of their patch cannot follow: too small for its elements, or curved too
// tightly for its edges.
#include <gtest/gtest.h>

#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include <algorithm>
#include <set>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

// With a fillet along its first circle.
Model filleted_cylinder(double radius, double height, double fillet_radius) {
  const TopoDS_Shape cylinder = BRepPrimAPI_MakeCylinder(radius, height).Shape();
  BRepFilletAPI_MakeFillet fillet(cylinder);
  fillet.Add(fillet_radius, TopoDS::Edge(TopExp_Explorer(cylinder, TopAbs_EDGE).Current()));
  return model_of(fillet.Shape());
}

bool tells(const MeshResult& mesh, const std::string& code) {
  return std::any_of(mesh.diagnostics.begin(), mesh.diagnostics.end(),
                     [&code](const Diagnostic& d) { return d.code == code; });
}

// The disc that the fillet leaves of the cylinder's end is two elements wide.
class SmallDisc : public testing::Test {
 protected:
  SmallDisc() : model(filleted_cylinder(2.37, 9, 1.6)) {
    settings.growth = 1.05;
    settings.feature_angle = 20.0;
  }

  std::vector<MeshResult> meshes() {
    std::vector<MeshResult> made;
    for (const double height : kHeights) made.push_back(mesh(height));
    return made;
  }
  MeshResult mesh(double height) {
    settings.size = 0.7;
    settings.first_height = height;
    return mesh_of(model, settings);
  }

  static constexpr double kHeights[] = {0.05, 0.175, 0.3};
  const Model model;
  Settings settings = test::coarse_settings();
};

TEST_F(SmallDisc, HoldsElementsAsItIsPartedWhereNeeded) {
  bool parted = false;
  for (const MeshResult& mesh : meshes()) {
    std::set<FaceId> held(mesh.quad_face.begin(), mesh.quad_face.end());
    held.insert(mesh.triangle_face.begin(), mesh.triangle_face.end());
    EXPECT_EQ(held.size(), model.faces().size());
    EXPECT_EQ(mesh.figures.inverted, 0);
    expect_watertight(mesh);
    parted = parted || tells(mesh, "patch-parted");
  }
  EXPECT_TRUE(parted);
}

// Patches that are none of the parted one's are not meshed again; they are what they would be.
TEST_F(SmallDisc, IsMeshedAsIfItHadBeenPartedFromTheOutset) {
  int parted = 0;
  for (const double height : kHeights) {
    settings.boundary_edges.clear();
    const MeshResult made = mesh(height);
    const auto note = std::find_if(made.diagnostics.begin(), made.diagnostics.end(),
                                   [](const Diagnostic& d) { return d.code == "patch-parted"; });
    if (note == made.diagnostics.end()) continue;
    ++parted;
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      const std::string name = face_name(FaceId(f));
      if (note->sentence.english().find(name) == std::string::npos) continue;
      for (const CoEdge& side : model.faces()[f].loops[0]) {
        if (!side.seam) settings.boundary_edges.push_back(side.edge);
      }
    }
    const MeshResult apart = mesh(height);
    EXPECT_FALSE(tells(apart, "patch-parted"));
    EXPECT_EQ(made.nodes, apart.nodes);
    EXPECT_EQ(made.quads, apart.quads);
    EXPECT_EQ(made.triangles, apart.triangles);
    for (std::size_t p = 0; p < made.patches.size(); ++p) {
      EXPECT_EQ(made.patches[p].patch, PatchId(p));
      EXPECT_EQ(made.patches[p].faces, apart.patches[p].faces);
    }
  }
  EXPECT_GT(parted, 0);
}

TEST_F(SmallDisc, StaysInThePatchWhereItsEdgeIsCalledSmooth) {
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    if (model.edges()[e].faces.size() == 2 && model.dihedral_angle(EdgeId(e)) < 0.1) {
      settings.smooth_edges.emplace_back(e);
    }
  }
  for (const MeshResult& mesh : meshes()) {
    EXPECT_FALSE(tells(mesh, "patch-parted"));
    EXPECT_EQ(mesh.patches.size(), 2u);
  }
}

// The circles' chords leave them by more than the fillet is wide, unless these are cut finer.
TEST(NarrowFillet, TurnsNoTriangleOver) {
  for (const double radius : {0.006, 0.01, 0.02}) {
    SCOPED_TRACE(radius);
    Settings settings = test::coarse_settings();
    settings.size = 0.6;
    settings.first_height = 0.05;
    settings.growth = 1.1;
    const MeshResult mesh = mesh_of(filleted_cylinder(2.6, 4, radius), settings);
    EXPECT_EQ(mesh.figures.inverted, 0);
    EXPECT_FALSE(tells(mesh, "triangulation-inverted"));
    expect_watertight(mesh);
  }
}

// Layers of this size cannot run across it: it is as if every face were a patch of its own.
TEST(NarrowFillet, IsNoSmoothSurfaceForElementsFarLarger) {
  const Model model = filleted_cylinder(2.6, 4, 0.02);
  Settings settings = test::coarse_settings();
  settings.size = 0.6;
  settings.first_height = 0.05;
  settings.growth = 1.1;
  const MeshResult apart = mesh_of(model, settings);
  settings.feature_angle = 20.0;
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_TRUE(tells(mesh, "patch-parted"));
  EXPECT_FALSE(tells(apart, "patch-parted"));
  EXPECT_EQ(mesh.figures.nodes, apart.figures.nodes);
  EXPECT_EQ(mesh.figures.quad_percent, apart.figures.quad_percent);
}

}  // namespace
}  // namespace advlayers::test
