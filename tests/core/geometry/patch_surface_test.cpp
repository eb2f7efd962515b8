#include "geometry/patch_surface.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pln.hxx>

#include <cmath>

#include "geometry/shapes.h"

namespace advlayers {
namespace {

using test::model_of;

// Four by four poles over [1, 4]^2.
TopoDS_Shape wavy_face() {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) poles(i, j) = gp_Pnt(i, j, 0.7 * std::sin(1.3 * i * j));
  }
  const Handle(Geom_Surface) wavy = new Geom_BezierSurface(poles);
  return BRepBuilderAPI_MakeFace(wavy, 1e-7).Shape();
}

SurfacePoint point_at(Evaluator& evaluator, FaceId face, double a, double b) {
  const Face& f = evaluator.model().face(face);
  SurfacePoint p{face, f.u_min + a * (f.u_max - f.u_min), f.v_min + b * (f.v_max - f.v_min),
                 Vec3::Zero()};
  p.xyz = evaluator.frame(face, p.u, p.v).xyz;
  return p;
}

// Length of the path that the chord throws on the surface, from 1024 projected chords.
double traced_length(PatchSurface& surface, const SurfacePoint& a, const SurfacePoint& b) {
  constexpr int kPieces = 1024;
  SurfacePoint previous = a;
  double length = 0.0;
  for (int i = 1; i <= kPieces; ++i) {
    SurfacePoint foot;
    EXPECT_TRUE(surface.project(a.xyz + (b.xyz - a.xyz) * i / kPieces, previous, foot));
    length += (foot.xyz - previous.xyz).norm();
    previous = foot;
  }
  return length;
}

TEST(PatchSurface, StepOnAPlaneIsExact) {
  const Model model = model_of(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 20, 0, 10).Shape());
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, {FaceId(0)});
  SurfacePoint to;
  ASSERT_TRUE(surface.step(point_at(evaluator, FaceId(0), 0.1, 0.1), Vec3(3, 4, 7), 5.0, to));
  EXPECT_LT((to.xyz - Vec3(5, 5, 0)).norm(), 1e-14);
}

TEST(PatchSurface, StepOnACylinderUnrolls) {
  for (const bool nurbs : {false, true}) {
    TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(2, 50).Shape();
    if (nurbs) shape = BRepBuilderAPI_NurbsConvert(shape).Shape();
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    PatchSurface surface(evaluator, {FaceId(0)});
    const SurfacePoint from = point_at(evaluator, FaceId(0), 0.3, 0.2);
    const Vec3 normal = evaluator.normal(from);
    const Vec3 around = Vec3::UnitZ().cross(normal);
    for (const double length : {1e-4, 0.01, 0.3, 2.0, 9.0}) {
      for (const double slope : {0.0, 0.5, 2.0}) {
        SurfacePoint to;
        ASSERT_TRUE(surface.step(from, around + slope * Vec3::UnitZ(), length, to));
        const double run = length / std::hypot(1.0, slope), angle = run / 2.0;
        const Vec3 expected = 2.0 * (std::cos(angle) * normal + std::sin(angle) * around) +
                              Vec3::UnitZ() * (from.xyz.z() + slope * run);
        EXPECT_LT((to.xyz - expected).norm(), 2e-6 * length) << length << " " << slope;
      }
    }
  }
}

TEST(PatchSurface, StepOnASphereFollowsAGreatCircleThroughThePole) {
  for (const bool nurbs : {false, true}) {
    TopoDS_Shape shape = BRepPrimAPI_MakeSphere(2.5).Shape();
    if (nurbs) shape = BRepBuilderAPI_NurbsConvert(shape).Shape();
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    PatchSurface surface(evaluator, {FaceId(0)});
    const SurfacePoint from = point_at(evaluator, FaceId(0), 0.3, 0.9);
    const Vec3 n = from.xyz.normalized();
    const Vec3 up = (Vec3::UnitZ() - n.z() * n).normalized();
    for (const double sideways : {0.0, 1e-3, 0.3}) {
      const Vec3 d = (up + sideways * up.cross(n)).normalized();
      for (const double length : {0.01, 0.5, 2.0}) {
        SurfacePoint to;
        ASSERT_TRUE(surface.step(from, d, length, to)) << sideways << " " << length;
        const double angle = length / 2.5;
        const Vec3 expected = 2.5 * (std::cos(angle) * n + std::sin(angle) * d);
        EXPECT_LT((to.xyz - expected).norm(), 2e-6 * length) << sideways << " " << length;
      }
    }
  }
}

TEST(PatchSurface, StepIsAsLongAsAskedOnFreeForms) {
  for (const TopoDS_Shape& shape :
       {wavy_face(), TopoDS_Shape(BRepPrimAPI_MakeTorus(1.5, 0.5).Shape())}) {
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    PatchSurface surface(evaluator, {FaceId(0)});
    const SurfacePoint from = point_at(evaluator, FaceId(0), 0.4, 0.45);
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.785 * k + 0.1;
      const SurfaceFrame frame = evaluator.frame(from.face, from.u, from.v);
      const Vec3 d =
          std::cos(angle) * frame.du.normalized() + std::sin(angle) * frame.dv.normalized();
      for (const double length : {1e-5, 1e-3, 0.02, 0.1}) {
        SurfacePoint to;
        ASSERT_TRUE(surface.step(from, d, length, to));
        EXPECT_NEAR(traced_length(surface, from, to), length, 2e-6 * length)
            << k << " " << length << " " << model.faces()[0].u_period;
        EXPECT_GT((to.xyz - from.xyz).normalized().dot(d.normalized()), 0.97);
      }
    }
  }
}

TEST(PatchSurface, StepAlongTheNormalIsRefused) {
  const Model model = model_of(BRepPrimAPI_MakeSphere(2.5).Shape());
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, {FaceId(0)});
  const SurfacePoint from = point_at(evaluator, FaceId(0), 0.3, 0.6);
  SurfacePoint to;
  EXPECT_FALSE(surface.step(from, evaluator.normal(from), 0.1, to));
}

TEST(PatchSurface, StepOffTheEndOfAFreeFormIsRefused) {
  const Model model = model_of(wavy_face());
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, {FaceId(0)});
  SurfacePoint to;
  EXPECT_FALSE(surface.step(point_at(evaluator, FaceId(0), 0.9, 0.5), Vec3::UnitX(), 1.5, to));
}

// The mantle of a cylinder of radius 2 and height 5, cut along into quarters.
Model quartered_cylinder() {
  const TopoDS_Shape whole = BRepPrimAPI_MakeCylinder(2, 5).Shape();
  TopoDS_Shape shape = TopExp_Explorer(whole, TopAbs_FACE).Current();
  for (const bool along_x : {true, false}) {
    const gp_Dir normal = along_x ? gp_Dir(0, 1, 0) : gp_Dir(1, 0, 0);
    const TopoDS_Shape knife =
        BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), normal), -9, 9, -9, 9);
    BRepAlgoAPI_Splitter splitter;
    TopTools_ListOfShape arguments, tools;
    arguments.Append(shape);
    tools.Append(knife);
    splitter.SetArguments(arguments);
    splitter.SetTools(tools);
    splitter.Build();
    shape = splitter.Shape();
  }
  return model_of(shape);
}

std::vector<FaceId> faces_of_kind(const Model& model, SurfaceKind kind) {
  std::vector<FaceId> faces;
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    if (model.faces()[f].kind == kind) faces.emplace_back(f);
  }
  return faces;
}

TEST(PatchSurface, WalksOnOverSmoothEdgesAroundACylinder) {
  const Model model = quartered_cylinder();
  Evaluator evaluator(model);
  const std::vector<FaceId> mantle = faces_of_kind(model, SurfaceKind::kCylinder);
  ASSERT_GE(mantle.size(), 4u);
  PatchSurface surface(evaluator, mantle);
  for (const FaceId face : mantle) {
    const SurfacePoint from = point_at(evaluator, face, 0.4, 0.3);
    const Vec3 normal = evaluator.normal(from);
    const Vec3 around = Vec3::UnitZ().cross(normal);
    for (const double slope : {0.0, 0.1, -0.05}) {
      for (const double length : {0.1, 2.0, 5.0, 9.0, 14.0}) {
        SurfacePoint to;
        ASSERT_TRUE(surface.step(from, around + slope * Vec3::UnitZ(), length, to));
        const double run = length / std::hypot(1.0, slope), angle = run / 2.0;
        const Vec3 expected = 2.0 * (std::cos(angle) * normal + std::sin(angle) * around) +
                              Vec3::UnitZ() * (from.xyz.z() + slope * run);
        EXPECT_LT((to.xyz - expected).norm(), 2e-6 * length) << length << " " << slope;
        EXPECT_TRUE(evaluator.inside(to.face, to.u, to.v));
      }
    }
  }
}

TEST(PatchSurface, ProjectsOverSmoothEdgesOntoTheFaceThatHasTheFoot) {
  const Model model = quartered_cylinder();
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, faces_of_kind(model, SurfaceKind::kCylinder));
  SurfacePoint seed = point_at(evaluator, surface.faces()[0], 0.5, 0.5);
  for (int k = 1; k <= 40; ++k) {
    const double angle = 0.3 * k;
    const Vec3 normal(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 off = 2.1 * normal + Vec3(0, 0, 2.5);
    if (k == 1) seed = evaluator.closest(seed.face, off);
    SurfacePoint foot;
    ASSERT_TRUE(surface.project(off, seed, foot));
    EXPECT_LT((foot.xyz - (2.0 * normal + Vec3(0, 0, 2.5))).norm(), 1e-12);
    if (k > 1) {
      EXPECT_TRUE(evaluator.inside(foot.face, foot.u, foot.v)) << k;
    }
    seed = foot;
  }
}

TEST(PatchSurface, StaysOnTheOwnSurfaceBeyondASharpEdge) {
  const Model model = quartered_cylinder();
  Evaluator evaluator(model);
  PatchSurface surface(evaluator, faces_of_kind(model, SurfaceKind::kCylinder));
  const SurfacePoint from = point_at(evaluator, surface.faces()[0], 0.5, 0.9);
  SurfacePoint to;
  ASSERT_TRUE(surface.step(from, Vec3::UnitZ(), 3.0, to));
  EXPECT_EQ(to.face, from.face);
  EXPECT_LT((to.xyz - from.xyz - 3.0 * Vec3::UnitZ()).norm(), 1e-12);
}

TEST(PatchSurface, WalksFromPlaneToRoundAndBack) {
  // A block with a rounded edge: plane, quarter cylinder, plane, all smooth.
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(4, 4, 4).Shape();
  BRepFilletAPI_MakeFillet fillet(block);
  TopExp_Explorer edge(block, TopAbs_EDGE);
  fillet.Add(1.0, TopoDS::Edge(edge.Current()));
  const Model model = model_of(fillet.Shape());
  Evaluator evaluator(model);
  const FaceId round = faces_of_kind(model, SurfaceKind::kCylinder).at(0);
  std::vector<FaceId> patch{round};
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    const std::vector<FaceId>& faces = model.edges()[e].faces;
    if (faces.size() != 2 || model.dihedral_angle(EdgeId(e)) > 0.1) continue;
    patch.push_back(faces[0] == round ? faces[1] : faces[0]);
  }
  ASSERT_EQ(patch.size(), 3u);
  PatchSurface surface(evaluator, patch);
  const Face& bend = model.face(round);
  const SurfacePoint middle = point_at(evaluator, round, 0.5, 0.5);
  const Vec3 across = evaluator.frame(round, middle.u, middle.v).du.normalized();
  ASSERT_NEAR(bend.u_max - bend.u_min, M_PI / 2, 1e-9);
  SurfacePoint on_plane, back;
  // From the middle of the bend over its border onto the plane, 1 further.
  ASSERT_TRUE(surface.step(middle, across, M_PI / 4 + 1.0, on_plane));
  EXPECT_NE(on_plane.face, round);
  EXPECT_EQ(model.face(on_plane.face).kind, SurfaceKind::kPlane);
  const Vec3 normal = evaluator.normal(on_plane);
  Vec3 home = middle.xyz - on_plane.xyz;
  home -= home.dot(normal) * normal;
  ASSERT_TRUE(surface.step(on_plane, home, 2.0 + M_PI / 2, back));
  EXPECT_NE(back.face, round);
  EXPECT_NE(back.face, on_plane.face);
  EXPECT_NEAR((back.xyz - middle.xyz).norm(), (on_plane.xyz - middle.xyz).norm(), 1e-6);
}

}  // namespace
}  // namespace advlayers
