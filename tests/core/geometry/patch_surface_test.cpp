#include "geometry/patch_surface.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array2OfPnt.hxx>
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

}  // namespace
}  // namespace advlayers
