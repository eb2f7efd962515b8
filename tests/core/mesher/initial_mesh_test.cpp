// An existing mesh of the shape as the start: what of it is seen in the result, what is mended, and
// what is refused.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "base/error.h"
#include "geometry/shapes.h"
#include "layers/layer_shapes.h"
#include "mesher/mesh_of.h"
#include "sizing/initial_nodes.h"
#include "triangulate/triangulate.h"

namespace advlayers::test {
namespace {

// Triangles alone, without layers.
Settings plain_settings(double size) {
  Settings settings = settings_of(size);
  settings.walls_all = false;
  settings.core = CoreElements::kTriangles;
  return settings;
}

InitialMesh initial_of(const MeshResult& mesh) {
  InitialMesh initial{mesh.nodes, mesh.triangles};
  for (const auto& q : mesh.quads) {
    initial.triangles.push_back({q[0], q[1], q[2]});
    initial.triangles.push_back({q[0], q[2], q[3]});
  }
  return initial;
}

void set(Settings& settings, InitialMesh initial) {
  settings.initial_mesh = std::make_shared<InitialMesh>(std::move(initial));
}

Vec3 centroid(const InitialMesh& mesh, const std::array<int, 3>& t) {
  Vec3 sum = Vec3::Zero();
  for (const int v : t) sum += mesh.points[static_cast<std::size_t>(v)] / 3;
  return sum;
}

double area_of(const MeshResult& result) {
  const InitialMesh mesh = initial_of(result);
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.points[static_cast<std::size_t>(t[0])];
    area += (mesh.points[static_cast<std::size_t>(t[1])] - a)
                .cross(mesh.points[static_cast<std::size_t>(t[2])] - a)
                .norm() /
            2;
  }
  return area;
}

int nodes_within(const MeshResult& mesh, const Vec3& p, double radius) {
  return static_cast<int>(std::count_if(mesh.nodes.begin(), mesh.nodes.end(),
                                        [&](const Vec3& n) { return (n - p).norm() < radius; }));
}

std::string refusal(const Model& model, const Settings& settings) {
  try {
    RunContext context;
    Mesher(context, model, settings);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

class InitialMeshOfPlate : public testing::Test {
 protected:
  InitialMeshOfPlate() : model(model_of(rectangle(12, 6))) {}

  // Of 0.1 about `fine`, and of 0.5 far away from it.
  InitialMesh graded() const {
    Settings settings = plain_settings(0.5);
    settings.refinements.push_back({fine, 0.1, 0.8});
    return initial_of(mesh_of(model, settings));
  }

  Model model;
  Vec3 fine{9, 3, 0}, coarse{3, 3, 0};
};

TEST_F(InitialMeshOfPlate, IsFollowedWhereItIsFiner) {
  for (const CoreElements core : {CoreElements::kTriangles, CoreElements::kQuads}) {
    Settings settings = plain_settings(0.5);
    settings.core = core;
    const MeshResult without = mesh_of(model, settings);
    const InitialMesh initial = graded();
    set(settings, initial);
    const MeshResult with = mesh_of(model, settings);
    EXPECT_EQ(with.figures.inverted, 0);
    const auto given = std::count_if(initial.points.begin(), initial.points.end(),
                                     [&](const Vec3& p) { return (p - fine).norm() < 0.8; });
    const int there = nodes_within(with, fine, 0.8);
    // Of squares there are fewer than of triangles with edges as long.
    const double expected =
        static_cast<double>(given) * (core == CoreElements::kQuads ? std::sqrt(0.75) : 1.0);
    EXPECT_NEAR(there, expected, 0.25 * expected);
    EXPECT_GT(there, 8 * nodes_within(without, fine, 0.8));
    // And nowhere else.
    EXPECT_NEAR(nodes_within(with, coarse, 2), nodes_within(without, coarse, 2), 10);
  }
}

TEST_F(InitialMeshOfPlate, GivesTheCoreItsSizeBeyondLayers) {
  Settings settings = settings_of(0.5);
  settings.end = EndOfGrowth::kLayers;
  settings.layers = 4;
  const MeshResult without = mesh_of(model, settings);
  set(settings, graded());
  const MeshResult with = mesh_of(model, settings);
  EXPECT_GT(nodes_within(with, fine, 0.8), 8 * nodes_within(without, fine, 0.8));
  EXPECT_EQ(with.figures.inverted, 0);
  for (const MeshResult* mesh : {&without, &with}) {
    for (const WallReport& wall : mesh->walls) {
      EXPECT_NEAR(wall.achieved_min, settings.first_height, 1e-9);
      EXPECT_NEAR(wall.achieved_max, settings.first_height, 1e-9);
      EXPECT_EQ(wall.layers, 4);
    }
  }
}

TEST_F(InitialMeshOfPlate, CutsTheEdgesFinerWhereItIs) {
  const Vec3 corner(12, 6, 0);
  Settings fine_there = plain_settings(0.5);
  fine_there.refinements.push_back({corner, 0.1, 0.5});
  Settings settings = plain_settings(0.5);
  const int without = nodes_within(mesh_of(model, settings), corner, 0.5);
  set(settings, initial_of(mesh_of(model, fine_there)));
  EXPECT_GT(nodes_within(mesh_of(model, settings), corner, 0.5), 6 * without);
}

// Places that no other way would lead to: a mesh with its inner nodes shaken.
TEST_F(InitialMeshOfPlate, NodesAreWhereTheTriangulationStarts) {
  Settings settings = plain_settings(0.5);
  InitialMesh initial = initial_of(mesh_of(model, settings));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shake(-0.05, 0.05);
  const auto inside = [](const Vec3& p) {
    return p.x() > 0.4 && p.x() < 11.6 && p.y() > 0.4 && p.y() < 5.6;
  };
  std::vector<Vec3> shaken;
  for (Vec3& p : initial.points) {
    if (!inside(p)) continue;
    p += Vec3(shake(random), shake(random), 0);
    shaken.push_back(p);
  }
  settings.initial_nodes =
      std::make_shared<InitialNodes>(RunContext(), model, initial, std::vector<FaceId>{FaceId(0)});
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, {FaceId(0)});
  const Discretization cut = discretize(RunContext(), evaluator, settings);
  const Triangulation made = triangulate(RunContext(), surface, evaluator, cut, settings);
  int kept = 0;
  for (std::size_t i = 0; i < made.mesh.vertex_capacity(); ++i) {
    if (!made.mesh.alive(VertexH(i))) continue;
    const Vec3& v = made.mesh.position(VertexH(i));
    if (std::any_of(shaken.begin(), shaken.end(),
                    [&](const Vec3& p) { return (p - v).norm() < 1e-9; })) {
      ++kept;
    }
  }
  EXPECT_GT(kept, 0.9 * static_cast<double>(shaken.size()));
  EXPECT_GE(made.initial_nodes, kept);
}

TEST_F(InitialMeshOfPlate, IsRefinedWhereItIsCoarserThanSize) {
  Settings settings = plain_settings(0.5);
  const MeshResult without = mesh_of(model, settings);
  set(settings, {{{0, 0, 0}, {12, 0, 0}, {12, 6, 0}, {0, 6, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  const MeshResult with = mesh_of(model, settings);
  EXPECT_EQ(with.nodes, without.nodes);  // there is no node inside
  set(settings, initial_of(mesh_of(model, plain_settings(2.0))));
  const double ratio = static_cast<double>(mesh_of(model, settings).nodes.size()) /
                       static_cast<double>(without.nodes.size());
  EXPECT_NEAR(ratio, 1.0, 0.1);
}

TEST_F(InitialMeshOfPlate, IsThinnedWhereNodesCrowd) {
  Settings settings = plain_settings(0.5);
  InitialMesh initial = initial_of(mesh_of(model, settings));
  const double before = static_cast<double>(initial.points.size());
  const auto triangles = initial.triangles;
  // Every third triangle gets a node next to its first corner, and slivers about it.
  for (std::size_t t = 0; t < triangles.size(); t += 3) {
    const auto [a, b, c] = triangles[t];
    const int v = static_cast<int>(initial.points.size());
    const Vec3& corner = initial.points[static_cast<std::size_t>(a)];
    initial.points.push_back(corner + 0.03 * (centroid(initial, triangles[t]) - corner));
    initial.triangles[t] = {a, b, v};
    initial.triangles.insert(initial.triangles.end(), {{b, c, v}, {c, a, v}});
  }
  set(settings, initial);
  const MeshResult mesh = mesh_of(model, settings);
  EXPECT_GT(mesh.figures.min_angle, 25);
  EXPECT_NEAR(static_cast<double>(mesh.nodes.size()), before, 0.1 * before);
}

TEST_F(InitialMeshOfPlate, IsRefusedWhereItDoesNotFit) {
  Settings settings = plain_settings(0.5);
  const InitialMesh sound = graded();
  InitialMesh bad = sound;
  bad.triangles.clear();
  set(settings, bad);
  EXPECT_NE(refusal(model, settings).find("no surface elements"), std::string::npos);

  bad = sound;
  bad.triangles[1][2] = 1 << 20;
  set(settings, bad);
  EXPECT_NE(refusal(model, settings).find("triangle 1 (from 0) has node 1048576"),
            std::string::npos);

  bad = sound;
  bad.points[4].y() = std::numeric_limits<double>::quiet_NaN();
  set(settings, bad);
  EXPECT_NE(refusal(model, settings).find("node 4 (from 0)"), std::string::npos);

  bad = sound;
  for (Vec3& p : bad.points) p.z() += 1.5;
  set(settings, bad);
  EXPECT_NE(refusal(model, settings).find("lies 1.5 mm off the shape"), std::string::npos);

  bad = sound;
  bad.triangles.erase(std::remove_if(bad.triangles.begin(), bad.triangles.end(),
                                     [&](const auto& t) { return centroid(bad, t).x() < 6; }),
                      bad.triangles.end());
  set(settings, bad);
  EXPECT_NE(refusal(model, settings).find("on Face1"), std::string::npos);

  set(settings, sound);
  EXPECT_EQ(refusal(model, settings), "");
}

TEST(InitialMesh, ThatMissesAFaceIsRefused) {
  const Model model = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  Settings settings = plain_settings(0.8);
  const MeshResult whole = mesh_of(model, settings);
  InitialMesh initial{whole.nodes, {}};
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    if (whole.triangle_face[t] != FaceId(2)) initial.triangles.push_back(whole.triangles[t]);
  }
  set(settings, initial);
  EXPECT_NE(refusal(model, settings).find("on Face3"), std::string::npos);
  settings.faces = {FaceId(0), FaceId(4)};  // where it is not needed, it may be missing
  EXPECT_EQ(refusal(model, settings), "");
}

TEST(InitialMesh, OffTheShapeByLittleIsPutOntoIt) {
  const Model model = model_of(BRepPrimAPI_MakeSphere(10).Shape());
  Settings settings = plain_settings(2);
  InitialMesh initial = initial_of(mesh_of(model, settings));
  for (Vec3& p : initial.points) p *= 1.02;  // by a tenth of the size
  set(settings, initial);
  const MeshResult mesh = mesh_of(model, settings);
  for (const Vec3& p : mesh.nodes) EXPECT_NEAR(p.norm(), 10, 1e-9);
  const auto note =
      std::find_if(mesh.diagnostics.begin(), mesh.diagnostics.end(),
                   [](const Diagnostic& d) { return d.code == "initial-mesh-moved"; });
  ASSERT_NE(note, mesh.diagnostics.end());
  const std::string said = note->sentence.english();
  EXPECT_NE(said.find("by up to 0.2 mm"), std::string::npos) << said;
}

// Seams, poles, holes, patches of several faces: as sound as without, and the same for any number
// of threads.
class InitialMeshOfSolid : public testing::TestWithParam<int> {
 protected:
  static TopoDS_Shape shape() {
    switch (GetParam()) {
      case 0:
        return BRepPrimAPI_MakeSphere(5).Shape();
      case 1:
        return BRepPrimAPI_MakeTorus(10, 3).Shape();
      case 2:
        return BRepPrimAPI_MakeCylinder(4, 9).Shape();
      default:
        return BRepAlgoAPI_Cut(
                   BRepPrimAPI_MakeBox(10, 8, 3).Shape(),
                   BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 4, -1), gp::DZ()), 2, 5).Shape())
            .Shape();
    }
  }
};

TEST_P(InitialMeshOfSolid, GivesASoundMesh) {
  const Model model = model_of(shape());
  Settings settings = settings_of(0.8);
  settings.feature_angle = 20;
  const MeshResult without = mesh_of(model, settings);
  for (const double size : {2.0, 0.8, 0.4}) {
    SCOPED_TRACE(size);
    set(settings, initial_of(mesh_of(model, plain_settings(size))));
    settings.threads = 1;
    const MeshResult with = mesh_of(model, settings);
    EXPECT_EQ(with.figures.inverted, 0);
    expect_watertight(with);
    EXPECT_NEAR(area_of(with), area_of(without), 0.01 * area_of(without));
    EXPECT_GT(with.figures.quad_percent, 97);
    settings.threads = 2;
    const MeshResult again = mesh_of(model, settings);
    EXPECT_EQ(with.nodes, again.nodes);
    EXPECT_EQ(with.quads, again.quads);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, InitialMeshOfSolid, testing::Range(0, 4));

}  // namespace
}  // namespace advlayers::test
