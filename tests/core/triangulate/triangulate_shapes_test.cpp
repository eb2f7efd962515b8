// Shapes that are awkward for one reason each.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>

#include "triangulate/face_by_face.h"

namespace advlayers {
namespace {

using namespace test;

TopoDS_Wire circle(double radius, double x = 0) {
  const gp_Circ round(gp_Ax2(gp_Pnt(x, 0, 0), gp_Dir(0, 0, 1)), radius);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(round).Edge()).Wire();
}

TopoDS_Face ring(double outer, double inner, double inner_x = 0) {
  BRepBuilderAPI_MakeFace face(gp_Pln(), circle(outer));
  face.Add(TopoDS::Wire(circle(inner, inner_x).Reversed()));
  return face.Face();
}

// z = height (x^2 - y^2) / 16 over a square of side 8, as a polynomial surface.
TopoDS_Face saddle(double height) {
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  const double bend[] = {height, -height, height};  // poles of height t^2 on -1 ... 1
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      poles(i + 1, j + 1) = gp_Pnt(4 * (i - 1), 4 * (j - 1), bend[i] - bend[j]);
    }
  }
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  return BRepBuilderAPI_MakeFace(surface, 1e-6).Face();
}

TEST(TriangulateShapes, ThinRing) {
  FaceByFace(ring(10, 9.9), 2).expect({0}, {2 * kDegree, 1 * kDegree});
}

TEST(TriangulateShapes, Saddle) { FaceByFace(saddle(4), 0.5).expect({1}); }

TEST(TriangulateShapes, ReversedFaceTurnsItsTriangles) {
  FaceByFace faces(saddle(2).Reversed(), 0.7);
  faces.expect({1});
  const Triangulation made = faces.mesh(FaceId(0));
  for (const Corners& t : triangles_of(made.mesh)) ASSERT_LT(t.cross().z(), 0);
}

TEST(TriangulateShapes, MirroredSolid) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0)));
  const TopoDS_Shape solid = BRepPrimAPI_MakeCylinder(5, 8).Shape();
  FaceByFace(BRepBuilderAPI_Transform(solid, mirror).Shape(), 1.2).expect({0, 1, 1});
}

TEST(TriangulateShapes, ExtrudedSpline) {
  TColgp_Array1OfPnt points(1, 7);
  const double wave[] = {0, 2, -1, 1.5, 0, -2, 0};
  for (int i = 1; i <= 7; ++i) points(i) = gp_Pnt(3 * i, wave[i - 1], 0);
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(points).Curve()).Edge();
  FaceByFace(BRepPrimAPI_MakePrism(edge, gp_Vec(0, 0, 6)).Shape(), 0.8).expect({1});
}

TEST(TriangulateShapes, TrimmedSpherePatch) {
  FaceByFace faces(BRepPrimAPI_MakeSphere(10, -0.4, 0.7, 1.1).Shape(), 1);
  PatchSurface surface(faces.evaluator, {FaceId(0)});
  const Triangulation made =
      triangulate(RunContext(), surface, faces.evaluator, faces.cut, faces.settings);
  EXPECT_TRUE(made.diagnostics.empty());
  expect_sound(made, surface, faces.evaluator, faces.cut, faces.settings, 1);
}

TEST(TriangulateShapes, SizeBeyondTheCurvature) {
  // Curvature alone sizes the triangles; a fifth of a turn would fit into one of the asked size.
  FaceByFace(BRepPrimAPI_MakeSphere(1).Shape(), 100)
      .expect({2}, {25 * kDegree, 30 * kDegree, 0.05});
  FaceByFace(BRepPrimAPI_MakeCylinder(1, 4).Shape(), 100)
      .expect({0, 1, 1}, {3 * kDegree, 30 * kDegree, 0.05});
}

// A box with all its edges rounded: planes, quarter cylinders and eighths of spheres.
TopoDS_Shape rounded_box() {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(10, 8, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
    fillet.Add(1.5, TopoDS::Edge(edge.Current()));
  }
  return fillet.Shape();
}

TEST(TriangulateShapes, SmoothFacesBecomeOne) {
  FaceByFace faces(rounded_box(), 0.7);
  faces.settings.feature_angle = 20;
  faces.expect_as_one(2);
}

// The eighths of spheres have a pole on their border.
TEST(TriangulateShapes, PolesOnTheBorder) {
  for (const double size : {0.3, 0.7, 2.0}) {
    SCOPED_TRACE(size);
    FaceByFace(rounded_box(), size)
        .expect(std::vector<int>(26, 1), {15 * kDegree, 30 * kDegree, 0.03});
  }
}

// A slit bounds the face on both its sides.
TEST(TriangulateShapes, Slit) {
  const TopoDS_Edge outer =
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 4)).Edge();
  const TopoDS_Vertex start = TopoDS::Vertex(TopExp_Explorer(outer, TopAbs_VERTEX).Current());
  const TopoDS_Vertex tip = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 0, 0)).Vertex();
  const TopoDS_Edge slit = BRepBuilderAPI_MakeEdge(start, tip).Edge();
  BRepBuilderAPI_MakeWire wire(outer);
  wire.Add(slit);
  wire.Add(TopoDS::Edge(slit.Reversed()));
  FaceByFace faces(BRepBuilderAPI_MakeFace(gp_Pln(), wire.Wire()).Face(), 0.8);
  faces.expect({1});
}

// The border passes twice through the corner where a hole touches it: two vertices, one node.
TEST(TriangulateShapes, HoleThatTouchesACorner) {
  const auto vertex = [](double x, double y) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, 0)).Vertex();
  };
  const auto polygon = [](const std::vector<TopoDS_Vertex>& corners) {
    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      wire.Add(BRepBuilderAPI_MakeEdge(corners[i], corners[(i + 1) % corners.size()]).Edge());
    }
    return wire.Wire();
  };
  const TopoDS_Vertex shared = vertex(0, 0);
  BRepBuilderAPI_MakeFace face(gp_Pln(),
                               polygon({shared, vertex(9, 0), vertex(9, 9), vertex(0, 9)}));
  face.Add(polygon({shared, vertex(2, 5), vertex(5, 2)}));
  FaceByFace faces(face.Face(), 1);
  ASSERT_EQ(faces.model.faces().front().defect.english(), "");
  faces.expect({1}, {12 * kDegree});
  const Triangulation made = faces.mesh(FaceId(0));
  std::map<NodeId, int> vertices;
  for (std::size_t i = 0; i < made.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (made.mesh.alive(v) && made.mesh.data(v).node.valid()) ++vertices[made.mesh.data(v).node];
  }
  int doubled = 0;
  for (const auto& [node, count] : vertices) {
    EXPECT_LE(count, 2);
    doubled += count == 2;
  }
  EXPECT_EQ(doubled, 1);
}

TEST(TriangulateShapes, NamesEdgesThatAreTooCoarse) {
  FaceByFace faces(ring(10, 9, -0.9), 100);
  faces.cut = cut_edges(faces.evaluator, 100, 130);
  try {
    faces.mesh(FaceId(0));
    FAIL() << "the chords of the circles cross";
  } catch (const BoundaryTooCoarse& error) {
    EXPECT_EQ(error.edges(), (std::vector<EdgeId>{EdgeId(0), EdgeId(1)}));
    EXPECT_NE(std::string(error.what()).find("Face1"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Edge2"), std::string::npos);
  }
  faces.cut = cut_edges(faces.evaluator, 0.3);
  faces.expect({0}, {10 * kDegree});
}

TEST(TriangulateShapes, NamesAHoleBeyondAChord) {
  FaceByFace faces(ring(10, 0.05, -9.9), 100);
  faces.cut = cut_edges(faces.evaluator, 100, 130);
  EXPECT_THROW(faces.mesh(FaceId(0)), BoundaryTooCoarse);
}

}  // namespace
}  // namespace advlayers
