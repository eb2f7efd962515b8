// Shapes as CAD programs leave them: gaps closed by edges of no length, edges within their own
// tolerance, boundaries that go back on themselves.
#include <gtest/gtest.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Plane.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <set>

#include "geometry/shapes.h"
#include "mesher/mesh_of.h"

namespace advlayers::test {
namespace {

void set_tolerances(const TopoDS_Shape& shape, double tolerance) {
  BRep_Builder builder;
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next()) {
    builder.UpdateEdge(TopoDS::Edge(it.Current()), tolerance);
  }
  for (TopExp_Explorer it(shape, TopAbs_VERTEX); it.More(); it.Next()) {
    builder.UpdateVertex(TopoDS::Vertex(it.Current()), tolerance);
  }
}

double shortest_edge(const MeshResult& mesh) {
  double shortest = 1e300;
  for (const auto& [ends, uses] : uses_of_edges(mesh)) {
    const Vec3 chord = mesh.nodes[std::size_t(ends.first)] - mesh.nodes[std::size_t(ends.second)];
    shortest = std::min(shortest, chord.norm());
  }
  return shortest;
}

std::set<FaceId> meshed_faces(const MeshResult& mesh) {
  std::set<FaceId> held(mesh.quad_face.begin(), mesh.quad_face.end());
  held.insert(mesh.triangle_face.begin(), mesh.triangle_face.end());
  return held;
}

std::string told(const MeshResult& mesh, const std::string& code) {
  std::string text;
  for (const Diagnostic& d : mesh.diagnostics) {
    if (d.code == code) text += d.sentence.english() + "\n";
  }
  return text;
}

void expect_whole(const Model& model, const MeshResult& mesh, double size) {
  EXPECT_EQ(meshed_faces(mesh).size(), model.faces().size());
  EXPECT_EQ(mesh.figures.inverted, 0);
  EXPECT_GT(shortest_edge(mesh), size / 1000);
  for (const Diagnostic& d : mesh.diagnostics) {
    EXPECT_NE(d.severity, Severity::kError) << d.sentence.english();
  }
}

// Of straight edges in the plane z = 0.
TopoDS_Wire polygon(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon made;
  for (const gp_Pnt& corner : corners) made.Add(corner);
  made.Close();
  return made.Wire();
}

TopoDS_Edge interpolated(const std::vector<gp_Pnt>& points) {
  const Handle(TColgp_HArray1OfPnt) at =
      new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) at->SetValue(static_cast<int>(i) + 1, points[i]);
  GeomAPI_Interpolate interpolate(at, Standard_False, 1e-9);
  interpolate.Perform();
  return BRepBuilderAPI_MakeEdge(interpolate.Curve());
}

// A square of which one corner is closed by a degenerate edge, `gap` long in (u, v).
TopoDS_Face square_with_gap(double gap) {
  const TopoDS_Wire square =
      polygon({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(0, 10, 0)});
  const Handle(Geom_Plane) plane = new Geom_Plane(gp::XOY());
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, plane, 1e-7);
  TopExp_Explorer corner(square, TopAbs_VERTEX);
  const TopoDS_Vertex vertex = TopoDS::Vertex(corner.Current());
  builder.UpdateVertex(vertex, 2 * gap);
  TopoDS_Edge pole;
  builder.MakeEdge(pole);
  const gp_Pnt at = BRep_Tool::Pnt(vertex);
  builder.UpdateEdge(pole, new Geom2d_Line(gp_Pnt2d(at.X(), at.Y()), gp::DX2d()), face, 1e-7);
  builder.Range(pole, 0.0, gap);
  builder.Degenerated(pole, Standard_True);
  builder.Add(pole, vertex.Oriented(TopAbs_FORWARD));
  builder.Add(pole, vertex.Oriented(TopAbs_REVERSED));
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  for (TopExp_Explorer it(square, TopAbs_EDGE); it.More(); it.Next())
    builder.Add(wire, it.Current());
  builder.Add(wire, pole);
  builder.Add(face, wire);
  return face;
}

TEST(RealCad, DegenerateEdgesThatCloseGapsAreNoPoles) {
  for (const double gap : {1e-8, 1e-6, 8e-4}) {
    const Model model = model_of(square_with_gap(gap));
    ASSERT_EQ(model.face(FaceId(0)).loops.size(), 1u);
    EXPECT_EQ(model.face(FaceId(0)).loops[0].size(), 4u) << gap;
    expect_whole(model, mesh_of(model, settings_of(1.0)), 1.0);
  }
  const Model sphere = model_of(BRepPrimAPI_MakeSphere(5).Shape());
  int poles = 0;
  for (const CoEdge& coedge : sphere.face(FaceId(0)).loops[0]) poles += coedge.degenerate;
  EXPECT_EQ(poles, 2);
}

TEST(RealCad, EdgesShorterThanTheirToleranceAreOnePoint) {
  for (const double length : {3e-7, 5e-6, 2e-5}) {
    const TopoDS_Face face = BRepBuilderAPI_MakeFace(
        polygon({gp_Pnt(0, 0, 0), gp_Pnt(10, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(5 + length, 10, 0),
                 gp_Pnt(5, 10, 0), gp_Pnt(0, 10, 0)}));
    set_tolerances(face, 1e-7);
    const Model exact = model_of(face);
    EXPECT_TRUE(told(mesh_of(exact, settings_of(1.0)), "below-tolerance").empty());
    set_tolerances(face, 1e-4);
    const Model loose = model_of(face);
    const MeshResult mesh = mesh_of(loose, settings_of(1.0));
    expect_whole(loose, mesh, 1.0);
    EXPECT_NE(told(mesh, "below-tolerance").find("Edge4 ("), std::string::npos);
    EXPECT_EQ(mesh.edge_segments[3].size(), 0u);
    // Naming such an edge is no fault.
    Settings walled = settings_of(1.0);
    walled.walls.push_back({});
    walled.walls.back().edges = {EdgeId(3)};
    expect_whole(loose, mesh_of(loose, walled), 1.0);
  }
}

// The hole's only vertex lies on the seam, and the hole to one side of it, or across.
TEST(RealCad, HolesAreFoundWhereTheirCurvesAre) {
  for (const double aside : {0.0, 0.3, -0.3}) {
    const gp_Ax2 axis(gp_Pnt(0, aside, 4), gp::DX());
    const TopoDS_Shape drilled = BRepAlgoAPI_Cut(BRepPrimAPI_MakeCylinder(1.0, 8.0).Shape(),
                                                 BRepPrimAPI_MakeCylinder(axis, 0.3, 5.0).Shape());
    const Model model = model_of(drilled);
    const MeshResult mesh = mesh_of(model, settings_of(0.2));
    expect_whole(model, mesh, 0.2);
    expect_watertight(mesh);
  }
}

// Between a curve along x and a line 5 below it.
TopoDS_Face face_under(const Handle(Geom_BSplineCurve) & curve) {
  const TopoDS_Edge top = BRepBuilderAPI_MakeEdge(curve);
  const gp_Pnt first = curve->StartPoint(), last = curve->EndPoint();
  const gp_Pnt low_last(last.X(), -5, 0), low_first(first.X(), -5, 0);
  BRepBuilderAPI_MakeWire wire(top, BRepBuilderAPI_MakeEdge(last, low_last),
                               BRepBuilderAPI_MakeEdge(low_last, low_first),
                               BRepBuilderAPI_MakeEdge(low_first, first));
  return BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire());
}

Handle(Geom_BSplineCurve)
    curve_with_knots(const std::vector<gp_Pnt>& poles, const std::vector<double>& knots,
                     const std::vector<int>& multiplicities) {
  TColgp_Array1OfPnt at(1, static_cast<int>(poles.size()));
  TColStd_Array1OfReal k(1, static_cast<int>(knots.size()));
  TColStd_Array1OfInteger m(1, static_cast<int>(knots.size()));
  for (std::size_t i = 0; i < poles.size(); ++i) at(static_cast<int>(i) + 1) = poles[i];
  for (std::size_t i = 0; i < knots.size(); ++i) {
    k(static_cast<int>(i) + 1) = knots[i];
    m(static_cast<int>(i) + 1) = multiplicities[i];
  }
  return new Geom_BSplineCurve(at, k, m, 3);
}

// By `back` in the middle.
TEST(RealCad, CurvesThatRunBackWithinTheirToleranceLeadOn) {
  for (const double back : {1e-7, 1e-5, 1e-3}) {
    const auto noisy =
        curve_with_knots({gp_Pnt(0, 0, 0), gp_Pnt(2, 0.2, 0), gp_Pnt(4, 0, 0), gp_Pnt(5, 0, 0),
                          gp_Pnt(5 + back, 0, 0), gp_Pnt(5 - back, 0, 0), gp_Pnt(5, 0, 0),
                          gp_Pnt(6, 0, 0), gp_Pnt(8, 0.2, 0), gp_Pnt(10, 0, 0)},
                         {0, 0.499, 0.501, 1}, {4, 3, 3, 4});
    const TopoDS_Face face = face_under(noisy);
    set_tolerances(face, 2 * back);
    const Model model = model_of(face);
    const MeshResult mesh = mesh_of(model, settings_of(1.0));
    expect_whole(model, mesh, 1.0);
    EXPECT_LT(mesh.edge_segments[0].size(), 60u);
  }
}

TEST(RealCad, ShortSpansMakeNoKinks) {
  const std::vector<gp_Pnt> poles{gp_Pnt(0, 0, 0), gp_Pnt(2, 1, 0), gp_Pnt(4, 1.5, 0),
                                  gp_Pnt(7, 1, 0), gp_Pnt(10, 0, 0)};
  const auto plain = curve_with_knots(poles, {0, 0.5, 1}, {4, 1, 4});
  const std::size_t segments =
      mesh_of(model_of(face_under(plain)), settings_of(1.0)).edge_segments[0].size();
  for (const double apart : {1e-9, 1e-8, 1e-6}) {
    const auto curve = curve_with_knots(poles, {0, 0.5, 1}, {4, 1, 4});
    curve->InsertKnot(0.3, 3, 1e-12);
    curve->InsertKnot(0.3 + apart, 3, 1e-12);
    curve->InsertKnot(0.3 + 2 * apart, 2, 1e-12);
    const Model model = model_of(face_under(curve));
    const MeshResult mesh = mesh_of(model, settings_of(1.0));
    expect_whole(model, mesh, 1.0);
    EXPECT_EQ(mesh.edge_segments[0].size(), segments) << apart;
  }
}

// Two flat faces that share an edge; the boundary of the second crosses itself.
TEST(RealCad, AFaceThatCannotBeMeshedCostsNoOther) {
  BRepBuilderAPI_Sewing sewing;
  sewing.Add(BRepBuilderAPI_MakeFace(
      polygon({gp_Pnt(0, 0, 0), gp_Pnt(5, 0, 0), gp_Pnt(5, 5, 0), gp_Pnt(0, 5, 0)})));
  sewing.Add(BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()),
                                     polygon({gp_Pnt(5, 0, 0), gp_Pnt(12, 3, 0), gp_Pnt(12, 1, 0),
                                              gp_Pnt(8, 7, 0), gp_Pnt(5, 5, 0)})));
  sewing.Perform();
  const Model model = model_of(sewing.SewedShape());
  ASSERT_EQ(model.faces().size(), 2u);
  for (const double feature_angle : {0.0, 20.0}) {
    Settings settings = settings_of(0.5);
    settings.feature_angle = feature_angle;
    const MeshResult mesh = mesh_of(model, settings);
    EXPECT_EQ(meshed_faces(mesh), std::set<FaceId>{FaceId(0)});
    EXPECT_EQ(told(mesh, "face-not-meshed").rfind("Face2: ", 0), 0u);
    EXPECT_EQ(told(mesh, "patch-parted").empty(), feature_angle == 0.0);
  }
}

// Between a line and a curve that leave the origin together, cross each other by `noise`, and part
// from x = 2 on.
TopoDS_Face vanishing_strip(double noise) {
  std::vector<gp_Pnt> high;
  for (int k = 0; k <= 20; ++k) {
    const double x = 0.5 * k, wave = k > 0 && k < 4 ? (k % 2 == 0 ? noise : -noise) : 0.0;
    high.emplace_back(x, wave + (x > 2 ? std::pow(x - 2, 3) / 100 : 0.0), 0);
  }
  const TopoDS_Edge curve = interpolated(high);
  const gp_Pnt first = high.front(), last = high.back(), below(last.X(), 0, 0);
  BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(first, below).Edge(),
                               BRepBuilderAPI_MakeEdge(below, last).Edge(), curve);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(gp_Pln(gp::XOY()), wire.Wire());
  set_tolerances(face, 2 * noise);
  return face;
}

TEST(RealCad, EdgesThatPartBeyondTheirToleranceAreOneLineUpToThere) {
  for (const double noise : {1e-5, 1e-4, 1e-3}) {
    const Model model = model_of(vanishing_strip(noise));
    for (const double size : {0.3, 0.8}) {
      const MeshResult mesh = mesh_of(model, settings_of(size));
      EXPECT_EQ(meshed_faces(mesh).size(), 1u) << noise << " at " << size;
      EXPECT_EQ(mesh.figures.inverted, 0);
      EXPECT_TRUE(told(mesh, "face-not-meshed").empty()) << told(mesh, "face-not-meshed");
    }
  }
}

// One block stands out by less than the tolerance over the other, which leaves a strip of a face.
TEST(RealCad, FacesNarrowerThanTheirToleranceHoldNothing) {
  const double step = 1e-5;
  const TopoDS_Shape shape =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeBox(10, 10, 4).Shape(),
                       BRepPrimAPI_MakeBox(gp_Pnt(10, 0, 0), gp_Pnt(16, 10, 4 + step)).Shape())
          .Shape();
  set_tolerances(shape, 3 * step);
  const Model model = model_of(shape);
  const MeshResult mesh = mesh_of(model, settings_of(1.0));
  std::set<FaceId> wide;
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    if (model.faces()[f].area > 1.0) wide.insert(FaceId(f));
  }
  ASSERT_EQ(wide.size() + 1, model.faces().size());
  EXPECT_EQ(meshed_faces(mesh), wide);
  EXPECT_NE(told(mesh, "below-tolerance").find("is narrower than"), std::string::npos);
  EXPECT_GT(shortest_edge(mesh), 1e-3);
  expect_watertight(mesh);
}

}  // namespace
}  // namespace advlayers::test
