#include "geometry/evaluator.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array2OfPnt.hxx>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "geometry/shapes.h"

namespace advlayers {
namespace {

using test::model_of;

gp_Trsf placed() {
  gp_Trsf trsf;
  trsf.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
  return trsf;
}

// Surfaces of every kind, each also as B-splines and each moved by a location.
std::vector<TopoDS_Shape> shapes() {
  std::vector<TopoDS_Shape> plain{
      BRepPrimAPI_MakeCylinder(2, 5).Shape(), BRepPrimAPI_MakeCone(3, 1, 4).Shape(),
      BRepPrimAPI_MakeCone(3, 0, 4).Shape(), BRepPrimAPI_MakeSphere(2.5).Shape(),
      BRepPrimAPI_MakeTorus(5, 1).Shape()};
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) poles(i, j) = gp_Pnt(i, j, 0.7 * std::sin(1.3 * i * j));
  }
  const Handle(Geom_Surface) wavy = new Geom_BezierSurface(poles);
  plain.push_back(BRepBuilderAPI_MakeFace(wavy, 1e-7).Shape());
  std::vector<TopoDS_Shape> all;
  for (const TopoDS_Shape& shape : plain) {
    all.push_back(shape);
    all.push_back(BRepBuilderAPI_NurbsConvert(shape).Shape());
    all.push_back(shape.Moved(TopLoc_Location(placed())));
  }
  return all;
}

TEST(Evaluator, FootOfAPointOffTheSurfaceIsWhereItCameFrom) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    const double precision = 1e-12 * model.diagonal();
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      const Face& face = model.faces()[f];
      for (int k = 0; k < 40; ++k) {
        const double u = face.u_min + (face.u_max - face.u_min) * (0.02 + 0.96 * unit(random));
        const double v = face.v_min + (face.v_max - face.v_min) * (0.02 + 0.96 * unit(random));
        const SurfaceFrame frame = evaluator.frame(FaceId(f), u, v);
        const double curvature = evaluator.max_curvature(FaceId(f), u, v);
        const double off =
            (unit(random) - 0.5) * std::min(0.3, curvature > 0 ? 0.3 / curvature : 1);
        SurfacePoint seed{FaceId(f), u, v, frame.xyz};
        seed.u += 0.04 * (unit(random) - 0.5) * (face.u_max - face.u_min);
        seed.v += 0.04 * (unit(random) - 0.5) * (face.v_max - face.v_min);
        SurfacePoint foot;
        ASSERT_TRUE(evaluator.project(frame.xyz + off * frame.normal, seed, foot))
            << face_name(foot.face);
        EXPECT_LT((foot.xyz - frame.xyz).norm(), 10 * precision)
            << "Face" << f + 1 << " off " << off;
        EXPECT_LT((foot.xyz - evaluator.frame(foot.face, foot.u, foot.v).xyz).norm(), precision);
      }
    }
  }
}

TEST(Evaluator, FootStaysOnTheSeedsSheetOfAClosedSurface) {
  for (const bool nurbs : {false, true}) {
    TopoDS_Shape shape = BRepPrimAPI_MakeCylinder(2, 5).Shape();
    if (nurbs) shape = BRepBuilderAPI_NurbsConvert(shape).Shape();
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    ASSERT_GT(model.faces()[0].u_period, 0.0);
    const double period = model.faces()[0].u_period;
    const double u = model.faces()[0].u_max + 0.01 * period, v = model.faces()[0].v_min + 1.0;
    const Vec3 xyz = evaluator.frame(FaceId(0), u, v).xyz;
    for (const double sheet : {-2.0, -1.0, 0.0, 3.0}) {
      SurfacePoint foot;
      const SurfacePoint seed{FaceId(0), u + (sheet - 0.02) * period, v, Vec3::Zero()};
      ASSERT_TRUE(evaluator.project(xyz, seed, foot));
      EXPECT_NEAR(foot.u, u + sheet * period, 1e-9);
      EXPECT_LT((foot.xyz - xyz).norm(), 1e-12);
    }
  }
}

TEST(Evaluator, NormalAtAPoleIsTheLimitFromInside) {
  for (const bool nurbs : {false, true}) {
    TopoDS_Shape ball = BRepPrimAPI_MakeSphere(2.5).Shape();
    TopoDS_Shape tip = BRepPrimAPI_MakeCone(3, 0, 4).Shape();
    if (nurbs) ball = BRepBuilderAPI_NurbsConvert(ball).Shape();
    if (nurbs) tip = BRepBuilderAPI_NurbsConvert(tip).Shape();
    for (const TopoDS_Shape& shape : {ball, TopoDS_Shape(ball.Reversed())}) {
      const Model model = model_of(shape);
      Evaluator evaluator(model);
      const Face& face = model.faces()[0];
      const SurfaceFrame pole = evaluator.frame(FaceId(0), 0.4 * face.u_max, face.v_max);
      EXPECT_TRUE(pole.degenerate);
      EXPECT_NEAR(std::abs(pole.normal.z()), 1.0, 1e-8);
      const double v_near = face.v_max - 0.1 * (face.v_max - face.v_min);
      EXPECT_GT(pole.normal.dot(evaluator.frame(FaceId(0), 0.4 * face.u_max, v_near).normal), 0.9);
    }
    const Model model = model_of(tip);
    Evaluator evaluator(model);
    const Face& face = model.faces()[0];
    const double u = 0.3 * face.u_max;
    const SurfaceFrame apex = evaluator.frame(FaceId(0), u, face.v_max);
    EXPECT_TRUE(apex.degenerate);
    const SurfaceFrame below = evaluator.frame(FaceId(0), u, 0.5 * (face.v_min + face.v_max));
    EXPECT_LT((apex.normal - below.normal).norm(), 1e-8);
  }
}

TEST(Evaluator, CurvatureIsThePrimitives) {
  const Model ball = model_of(BRepPrimAPI_MakeSphere(2.5).Shape());
  const Model ring = model_of(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(5, 1).Shape()));
  Evaluator on_ball(ball), on_ring(ring);
  const Face& face = ball.faces()[0];
  for (const double v : {face.v_min, 0.3, face.v_max}) {
    EXPECT_NEAR(on_ball.max_curvature(FaceId(0), 1.0, v), 0.4, 1e-6);
  }
  EXPECT_NEAR(on_ring.max_curvature(FaceId(0), 1.0, 2.0), 1.0, 1e-6);
}

TEST(Evaluator, ClosestNeedsNoSeedAndStaysOnTheTrimmedFace) {
  const gp_Ax2 axis(gp_Pnt(0.5, -5, 0.3), gp_Dir(0.1, 1, 0.2));
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(axis, 0.8, 12).Shape();
  for (const bool nurbs : {false, true}) {
    TopoDS_Shape shape = BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(2.5).Shape(), tool).Shape();
    if (nurbs) shape = BRepBuilderAPI_NurbsConvert(shape).Shape();
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-3.0, 3.0);
    for (int k = 0; k < 60; ++k) {
      const Vec3 xyz(unit(random), unit(random), unit(random));
      const SurfacePoint foot = evaluator.closest(FaceId(0), xyz);
      EXPECT_LT((evaluator.frame(foot.face, foot.u, foot.v).xyz - foot.xyz).norm(), 1e-9);
      const double distance = (foot.xyz - xyz).norm();
      // No point of the face is nearer.
      const Face& face = model.faces()[0];
      for (int i = 0; i <= 60; ++i) {
        for (int j = 0; j <= 60; ++j) {
          const double u = face.u_min + (face.u_max - face.u_min) * i / 60.0;
          const double v = face.v_min + (face.v_max - face.v_min) * j / 60.0;
          if (!evaluator.inside(FaceId(0), u, v)) continue;
          EXPECT_GT((evaluator.frame(FaceId(0), u, v).xyz - xyz).norm(), distance - 2e-3);
        }
      }
      // On the face: the foot is inside, or on a boundary curve.
      const double off_axis =
          (foot.xyz - Vec3(0.5, -5, 0.3)).cross(Vec3(0.1, 1, 0.2).normalized()).norm();
      EXPECT_GT(off_axis, 0.8 - 1e-5);
    }
  }
}

TEST(Evaluator, EdgeParameterInvertsEdgeLength) {
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    for (std::size_t e = 0; e < model.edges().size(); ++e) {
      const Edge& edge = model.edges()[e];
      if (edge.degenerate) continue;
      const EdgeId id(e);
      EXPECT_NEAR(evaluator.edge_length(id, edge.first, edge.last), edge.length,
                  1e-9 * edge.length);
      for (const double part : {0.1, 1.0 / 3.0, 0.5, 0.9}) {
        const double t = evaluator.edge_parameter(id, edge.first, part * edge.length);
        EXPECT_NEAR(evaluator.edge_length(id, edge.first, t), part * edge.length,
                    1e-12 * edge.length);
        EXPECT_NEAR(evaluator.edge_length(id, t, edge.last), (1 - part) * edge.length,
                    1e-9 * edge.length);
      }
      EXPECT_EQ(evaluator.edge_parameter(id, edge.first, 2 * edge.length), edge.last);
    }
  }
}

TEST(Evaluator, OnePerThreadGivesTheSameBitForBit) {
  const Model model = model_of(BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(5, 1).Shape()));
  const auto trace = [&model] {
    Evaluator evaluator(model);
    std::vector<double> seen;
    SurfacePoint at{FaceId(0), 1.0, 1.0, Vec3::Zero()};
    for (int k = 0; k < 3000; ++k) {
      const double angle = 0.01 * k;
      const Vec3 target(5.5 * std::cos(angle), 5.5 * std::sin(angle), std::sin(0.7 * k));
      evaluator.project(target, at, at);
      seen.insert(seen.end(), {at.u, at.v, at.xyz.x(), evaluator.normal(at).y()});
    }
    return seen;
  };
  const std::vector<double> alone = trace();
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (auto& result : together) threads.emplace_back([&] { result = trace(); });
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : together) EXPECT_EQ(result, alone);
}

TEST(Evaluator, EdgePointsLieOnTheirFaces) {
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      for (const auto& loop : model.faces()[f].loops) {
        for (const CoEdge& coedge : loop) {
          const Edge& edge = model.edge(coedge.edge);
          for (const double part : {0.0, 0.3, 1.0}) {
            const double t = edge.first + part * (edge.last - edge.first);
            const Vec2 uv = evaluator.edge_uv(FaceId(f), coedge, t);
            const Vec3 on_face = evaluator.frame(FaceId(f), uv.x(), uv.y()).xyz;
            EXPECT_LT((on_face - evaluator.edge_point(coedge.edge, t)).norm(), edge.tolerance);
          }
        }
      }
    }
  }
}

// A narrow band of nine turns: the samples nearest to a point lie on other turns than it.
TEST(Evaluator, FindsTheNearestPointOfAThread) {
  constexpr int kAlong = 145, kAcross = 4;
  TColgp_Array2OfPnt poles(1, kAlong, 1, kAcross);
  for (int i = 1; i <= kAlong; ++i) {
    const double angle = 18 * M_PI * (i - 1) / (kAlong - 1);
    for (int j = 1; j <= kAcross; ++j) {
      poles.SetValue(
          i, j,
          gp_Pnt(3 * std::cos(angle), 3 * std::sin(angle), angle / (2 * M_PI) + 0.04 * (j - 1)));
    }
  }
  const Model model = model_of(
      BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(poles).Surface(), 1e-7).Face());
  Evaluator evaluator(model);
  const Face& face = model.face(FaceId(0));
  for (int k = 1; k < 200; ++k) {
    const double u = face.u_min + (face.u_max - face.u_min) * k / 200;
    const double v = face.v_min + (face.v_max - face.v_min) * (k % 7 + 0.5) / 7;
    const Vec3 p = evaluator.frame(FaceId(0), u, v).xyz;
    EXPECT_LT((evaluator.closest(FaceId(0), p).xyz - p).norm(), 1e-6) << u << ' ' << v;
  }
}

// A drop's outline, drawn out: closed, but creased along its seam.
TEST(Evaluator, KeepsTheNormalsOfBothSidesOfACreasedSeam) {
  TColgp_Array2OfPnt poles(1, 4, 1, 2);
  const gp_Pnt outline[4] = {{0, 0, 0}, {3, 2, 0}, {3, -2, 0}, {0, 0, 0}};
  for (int i = 0; i < 4; ++i) {
    poles(i + 1, 1) = outline[i];
    poles(i + 1, 2) = outline[i].Translated(gp_Vec(0, 0, 1));
  }
  const Model model =
      model_of(BRepBuilderAPI_MakeFace(new Geom_BezierSurface(poles), Precision::Confusion()));
  ASSERT_EQ(model.faces()[0].u_period, 1.0);
  Evaluator evaluator(model);
  const auto normal = [&](double u) { return evaluator.frame(FaceId(0), u, 0.5).normal; };
  ASSERT_GT((normal(1e-6) - normal(1 - 1e-6)).norm(), 0.5);
  const double hair = 4 * std::numeric_limits<double>::epsilon();
  EXPECT_LT((normal(1 + hair) - normal(1 - 1e-6)).norm(), 1e-4);
  EXPECT_LT((normal(-hair) - normal(1e-6)).norm(), 1e-4);
}

}  // namespace
}  // namespace advlayers
