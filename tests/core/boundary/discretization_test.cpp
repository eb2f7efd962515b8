#include "boundary/discretization.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>

#include "base/error.h"
#include "coarse_settings.h"
#include "geometry/shapes.h"

namespace advlayers {
namespace {

using test::model_of;

Settings settings_of(double size, double curvature_angle = 20.0) {
  Settings settings = test::coarse_settings();
  settings.size = size;
  settings.first_height = 0.01 * size;
  settings.curvature_angle = curvature_angle;
  return settings;
}

Discretization cut(const Model& model, const Settings& settings) {
  Evaluator evaluator(model);
  return discretize(RunContext(), evaluator, settings);
}

TopoDS_Face bezier_sheet(double height) {
  TColgp_Array2OfPnt poles(1, 4, 1, 4);
  for (int i = 1; i <= 4; ++i) {
    for (int j = 1; j <= 4; ++j) poles(i, j) = gp_Pnt(i, j, height * std::sin(1.3 * i * j));
  }
  const Handle(Geom_Surface) surface = new Geom_BezierSurface(poles);
  return BRepBuilderAPI_MakeFace(surface, 1e-7).Face();
}

TopoDS_Shape pierced_sphere() {
  const gp_Ax2 axis(gp_Pnt(0.5, -5, 0.3), gp_Dir(0.1, 1, 0.2));
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(axis, 0.8, 12).Shape();
  return BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(2.5).Shape(), tool).Shape();
}

std::vector<TopoDS_Shape> shapes() {
  std::vector<TopoDS_Shape> all{BRepPrimAPI_MakeBox(4, 5, 6).Shape(),
                                BRepPrimAPI_MakeCylinder(2, 5).Shape(),
                                BRepPrimAPI_MakeCone(3, 0, 4).Shape(),
                                BRepPrimAPI_MakeSphere(2.5).Shape(),
                                BRepPrimAPI_MakeTorus(5, 1).Shape(),
                                bezier_sheet(0.7),
                                pierced_sphere()};
  const std::size_t plain = all.size();
  for (std::size_t i = 0; i < plain; ++i)
    all.push_back(BRepBuilderAPI_NurbsConvert(all[i]).Shape());
  return all;
}

// A planar face inside a closed polygon.
TopoDS_Face polygon(const std::vector<gp_Pnt>& points) {
  BRepBuilderAPI_MakePolygon wire;
  for (const gp_Pnt& p : points) wire.Add(p);
  wire.Close();
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

double turn(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

TEST(Discretization, SegmentsKeepToTheSizeAndTheCurvatureAngle) {
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    for (const double size : {0.3, 2.0, 50.0}) {
      for (const double degrees : {10.0, 25.0}) {
        Evaluator evaluator(model);
        const Discretization d = discretize(RunContext(), evaluator, settings_of(size, degrees));
        for (std::size_t e = 0; e < model.edges().size(); ++e) {
          const std::vector<double>& t = d.edges[e].params;
          for (std::size_t k = 1; k < t.size(); ++k) {
            // A tenth longer where that saves a segment.
            EXPECT_LT(evaluator.edge_length(EdgeId(e), t[k - 1], t[k]), 1.1 * size * (1 + 1e-9));
            double turned = 0.0;
            constexpr int kParts = 16;
            for (int i = 0; i < kParts; ++i) {
              const double a = t[k - 1] + (t[k] - t[k - 1]) * i / kParts;
              const double b = t[k - 1] + (t[k] - t[k - 1]) * (i + 1) / kParts;
              turned +=
                  turn(evaluator.edge_tangent(EdgeId(e), a), evaluator.edge_tangent(EdgeId(e), b));
            }
            EXPECT_LT(turned * 180.0 / M_PI, degrees * 1.02) << "Edge" << e + 1;
          }
        }
      }
    }
  }
}

TEST(Discretization, NodesLieOnTheExactCurvesAndAtTheVertices) {
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    Evaluator evaluator(model);
    const Discretization d = discretize(RunContext(), evaluator, settings_of(0.7));
    std::vector<int> met(d.nodes.size(), 0);
    for (std::size_t e = 0; e < model.edges().size(); ++e) {
      const Edge& edge = model.edges()[e];
      const EdgeNodes& cuts = d.edges[e];
      ASSERT_EQ(cuts.nodes.size(), cuts.params.size());
      ASSERT_FALSE(cuts.nodes.empty());
      for (const NodeId n : cuts.nodes) ++met[n.index()];
      EXPECT_EQ(d.nodes[cuts.nodes.front().index()].vertex, edge.start);
      EXPECT_EQ(d.nodes[cuts.nodes.back().index()].vertex, edge.end);
      EXPECT_EQ(cuts.params.front(), edge.first);
      if (edge.degenerate) {
        EXPECT_EQ(cuts.nodes.size(), 1u);
        continue;
      }
      EXPECT_EQ(cuts.params.back(), edge.last);
      for (std::size_t k = 0; k < cuts.nodes.size(); ++k) {
        const BoundaryNode& node = d.nodes[cuts.nodes[k].index()];
        const Vec3 on_curve = evaluator.edge_point(EdgeId(e), cuts.params[k]);
        const bool inner = k > 0 && k + 1 < cuts.nodes.size();
        EXPECT_LT((node.xyz - on_curve).norm(), inner ? 1e-15 : 1e-6);
        EXPECT_EQ(node.edge.valid(), inner);
        if (k == 0) continue;
        EXPECT_GT(cuts.params[k], cuts.params[k - 1]);
      }
    }
    for (const int count : met) EXPECT_GT(count, 0);
  }
}

TEST(Discretization, EvenEdgesAreCutEvenly) {
  const Model box = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  Evaluator on_box(box);
  const Discretization d = discretize(RunContext(), on_box, settings_of(1.1));
  for (std::size_t e = 0; e < box.edges().size(); ++e) {
    const double length = box.edges()[e].length;
    const auto segments = static_cast<int>(d.edges[e].nodes.size()) - 1;
    EXPECT_EQ(segments,
              static_cast<int>(std::ceil(length / (1.1 * 1.1))));  // a tenth over the size
    for (int k = 1; k <= segments; ++k) {
      const auto i = static_cast<std::size_t>(k);
      const Vec3 step =
          d.nodes[d.edges[e].nodes[i].index()].xyz - d.nodes[d.edges[e].nodes[i - 1].index()].xyz;
      EXPECT_NEAR(step.norm(), length / segments, 1e-12);
    }
  }
  // A full circle by the curvature angle alone.
  const Model cylinder = model_of(BRepPrimAPI_MakeCylinder(2, 5).Shape());
  const Discretization round = cut(cylinder, settings_of(100.0, 20.0));
  for (std::size_t e = 0; e < cylinder.edges().size(); ++e) {
    const bool circle = cylinder.edges()[e].start == cylinder.edges()[e].end;
    if (circle) {
      EXPECT_EQ(round.edges[e].nodes.size(), 19u);
    }
  }
}

TEST(Discretization, EveryLoopHoldsATriangle) {
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    const Discretization d = cut(model, settings_of(1000.0, 90.0));
    for (const Face& face : model.faces()) {
      for (const auto& loop : face.loops) {
        std::size_t segments = 0;
        for (const CoEdge& c : loop) segments += d.edges[c.edge.index()].nodes.size() - 1;
        EXPECT_GE(segments, 3u);
      }
    }
  }
  // Two shallow arcs between the same two points.
  const gp_Pnt a(0, 0, 0), b(10, 0, 0);
  const TopoDS_Edge under =
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, gp_Pnt(5, -0.1, 0), b).Value());
  const TopoDS_Edge over =
      BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(b, gp_Pnt(5, 0.1, 0), a).Value());
  const Model lens =
      model_of(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(under, over).Wire()).Face());
  const Discretization d = cut(lens, settings_of(100.0));
  EXPECT_EQ(d.edges[0].nodes.size(), d.edges[1].nodes.size());
  EXPECT_GE(d.edges[0].nodes.size() + d.edges[1].nodes.size() - 2, 3u);
}

TEST(Discretization, SegmentsGrowGentlyFromShortEdges) {
  const double tiny = 1e-3;
  const Model model =
      model_of(polygon({{0, 0, 0}, {10, 0, 0}, {10, 6 - tiny, 0}, {10 - tiny, 6, 0}, {0, 6, 0}}));
  Evaluator evaluator(model);
  const Discretization d = discretize(RunContext(), evaluator, settings_of(1.0));
  // Lengths of the segments around the loop.
  std::vector<double> lengths;
  for (const CoEdge& c : model.faces()[0].loops[0]) {
    const std::vector<double>& t = d.edges[c.edge.index()].params;
    std::vector<double> of_edge;
    for (std::size_t k = 1; k < t.size(); ++k)
      of_edge.push_back(evaluator.edge_length(c.edge, t[k - 1], t[k]));
    if (!c.forward) std::reverse(of_edge.begin(), of_edge.end());
    lengths.insert(lengths.end(), of_edge.begin(), of_edge.end());
  }
  const double growth = settings_of(1.0).size_growth;
  double shortest = 1.0, longest = 0.0;
  int above = 0;
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double ratio = lengths[(i + 1) % lengths.size()] / lengths[i];
    const double jump = std::max(ratio, 1.0 / ratio);
    EXPECT_LT(jump, 1.1 * growth);  // whole numbers of segments fit no stretch exactly
    above += jump > 1.001 * growth;
    shortest = std::min(shortest, lengths[i]);
    longest = std::max(longest, lengths[i]);
  }
  EXPECT_LE(above, 2);
  EXPECT_LE(shortest, tiny * std::sqrt(2.0) + 1e-12);
  EXPECT_GT(longest, 0.8);
  EXPECT_LT(lengths.size(), 90u);
}

TEST(Discretization, CutsDoNotDependOnTheDirectionOfTheCurve) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(1, 6, 0);
  poles(3) = gp_Pnt(2, -1, 0);
  poles(4) = gp_Pnt(9, 2, 0);
  Handle(Geom_Curve) curve = new Geom_BezierCurve(poles);
  std::vector<std::vector<Vec3>> ways;
  for (const bool backward : {false, true}) {
    const Handle(Geom_Curve) way = backward ? curve->Reversed() : curve;
    const TopoDS_Edge bent = BRepBuilderAPI_MakeEdge(way);
    const TopoDS_Edge side = BRepBuilderAPI_MakeEdge(gp_Pnt(9, 2, 0), gp_Pnt(5, 8, 0));
    const TopoDS_Edge back = BRepBuilderAPI_MakeEdge(gp_Pnt(5, 8, 0), gp_Pnt(0, 0, 0));
    const Model model =
        model_of(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(bent, side, back).Wire()).Face());
    const Discretization d = cut(model, settings_of(0.8, 10.0));
    for (std::size_t e = 0; e < 3; ++e) {
      const Edge& edge = model.edges()[e];
      if (edge.length < 9.0 || std::abs(edge.length - std::hypot(5.0, 8.0)) < 1e-6) continue;
      std::vector<Vec3>& points = ways.emplace_back();
      for (const NodeId n : d.edges[e].nodes) points.push_back(d.nodes[n.index()].xyz);
      if (points.front().x() > points.back().x()) std::reverse(points.begin(), points.end());
    }
  }
  ASSERT_EQ(ways.size(), 2u);
  ASSERT_EQ(ways[0].size(), ways[1].size());
  for (std::size_t i = 0; i < ways[0].size(); ++i)
    EXPECT_LT((ways[0][i] - ways[1][i]).norm(), 1e-9);
}

TEST(Discretization, MirroredShapesAreCutAlike) {
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2(gp_Pnt(0.3, 0.2, 0.1), gp_Dir(1, 2, 3)));
  for (const TopoDS_Shape& shape : shapes()) {
    const Model model = model_of(shape);
    const Model mirrored = model_of(BRepBuilderAPI_Transform(shape, mirror).Shape());
    const Discretization a = cut(model, settings_of(0.6)), b = cut(mirrored, settings_of(0.6));
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    for (const BoundaryNode& node : a.nodes) {
      const gp_Pnt image = gp_Pnt(node.xyz.x(), node.xyz.y(), node.xyz.z()).Transformed(mirror);
      double nearest = 1e9;
      for (const BoundaryNode& other : b.nodes) {
        nearest = std::min(nearest, (other.xyz - Vec3(image.X(), image.Y(), image.Z())).norm());
      }
      EXPECT_LT(nearest, 1e-9);
    }
  }
}

TEST(Discretization, KinksOfACurveTakeANode) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(4, 0, 0);
  poles(3) = gp_Pnt(5, 3, 0);
  poles(4) = gp_Pnt(0, 3, 0);
  TColStd_Array1OfReal knots(1, 4);
  TColStd_Array1OfInteger multiplicities(1, 4);
  for (int i = 1; i <= 4; ++i) {
    knots(i) = i;
    multiplicities(i) = i == 1 || i == 4 ? 2 : 1;
  }
  const Handle(Geom_Curve) zigzag = new Geom_BSplineCurve(poles, knots, multiplicities, 1);
  const TopoDS_Edge bent = BRepBuilderAPI_MakeEdge(zigzag);
  const TopoDS_Edge back = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 3, 0), gp_Pnt(0, 0, 0));
  const Model model =
      model_of(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(bent, back).Wire()).Face());
  const Discretization d = cut(model, settings_of(100.0));
  for (const Vec3& corner : {Vec3(4, 0, 0), Vec3(5, 3, 0)}) {
    double nearest = 1e9;
    for (const BoundaryNode& n : d.nodes) nearest = std::min(nearest, (n.xyz - corner).norm());
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(Discretization, ArcsFarShorterThanTheSizeAreOneSegment) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 5, 6).Shape();
  BRepFilletAPI_MakeFillet fillet(box);
  for (TopExp_Explorer edge(box, TopAbs_EDGE); edge.More(); edge.Next()) {
    fillet.Add(0.02, TopoDS::Edge(edge.Current()));
  }
  const Model model = model_of(fillet.Shape());
  for (const double size : {1.0, 0.1}) {
    const Discretization boundary = cut(model, settings_of(size));
    for (std::size_t e = 0; e < boundary.edges.size(); ++e) {
      const Edge& edge = model.edge(EdgeId(e));
      if (edge.degenerate || edge.length > 0.05) continue;
      const std::size_t segments = boundary.edges[e].nodes.size() - 1;
      // Else 90 degrees, of no more than 20 each.
      if (size == 1.0) {
        EXPECT_EQ(segments, 1u);
      } else {
        EXPECT_GE(segments, 4u);
      }
    }
  }
}

// Intersection curves of faces that touch run out beyond the vertex at times, and back beside
// themselves within the edge's tolerance.
TEST(Discretization, AnOvershootBeyondAVertexTakesNoNodes) {
  TColgp_Array1OfPnt poles(1, 4);
  poles(1) = gp_Pnt(0, 0, 0);
  poles(2) = gp_Pnt(-0.3, 5e-4, 0);
  poles(3) = gp_Pnt(1, 0, 0);
  poles(4) = gp_Pnt(4, 0, 0);
  const Handle(Geom_Curve) curve = new Geom_BezierCurve(poles);
  for (const bool reversed : {false, true}) {
    const Handle(Geom_Curve) way = reversed ? curve->Reversed() : curve;
    const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(way).Edge();
    BRep_Builder().UpdateEdge(edge, 1e-3);
    const gp_Pnt begin(0, 0, 0), end(4, 0, 0), apex(2, 3, 0);
    const TopoDS_Edge back = BRepBuilderAPI_MakeEdge(end, apex).Edge();
    const TopoDS_Edge home = BRepBuilderAPI_MakeEdge(apex, begin).Edge();
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge, back, home).Wire();
    const Model model = model_of(BRepBuilderAPI_MakeFace(wire, true).Face());
    const Discretization boundary = cut(model, settings_of(1.0));
    for (const BoundaryNode& node : boundary.nodes) EXPECT_GT(node.xyz.x(), -1e-9);
    for (const EdgeNodes& nodes : boundary.edges) {
      for (std::size_t k = 1; k < nodes.nodes.size(); ++k) {
        const Vec3 segment = boundary.nodes[nodes.nodes[k].index()].xyz -
                             boundary.nodes[nodes.nodes[k - 1].index()].xyz;
        EXPECT_GT(segment.norm(), 0.5);
      }
    }
  }
}

TEST(Discretization, AStraightEdgeOfATwistedFaceFollowsTheTwist) {
  // A hyperbolic paraboloid: straight edges, along which the normal turns by more than a right
  // angle.
  TColgp_Array2OfPnt poles(1, 3, 1, 3);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 3; ++j) poles(i, j) = gp_Pnt(i - 2, j - 2, 3.0 * (i - 2) * (j - 2));
  }
  const Handle(Geom_Surface) twisted = new Geom_BezierSurface(poles);
  const Model model = model_of(BRepBuilderAPI_MakeFace(twisted, 1e-7).Shape());
  Evaluator evaluator(model);
  const Discretization d = discretize(RunContext(), evaluator, settings_of(100.0));
  for (const CoEdge& c : model.faces()[0].loops[0]) {
    const std::vector<double>& t = d.edges[c.edge.index()].params;
    for (std::size_t k = 1; k < t.size(); ++k) {
      const Vec2 a = evaluator.edge_uv(FaceId(0), c, t[k - 1]),
                 b = evaluator.edge_uv(FaceId(0), c, t[k]);
      const double degrees = turn(evaluator.frame(FaceId(0), a.x(), a.y()).normal,
                                  evaluator.frame(FaceId(0), b.x(), b.y()).normal) *
                             180.0 / M_PI;
      EXPECT_LT(degrees, 31.0);
    }
  }
}

TEST(Discretization, EdgesOfNoMeshedFaceAreLeftEmpty) {
  const Model box = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  Settings settings = settings_of(1.0);
  settings.faces = {FaceId(2)};
  const Discretization d = cut(box, settings);
  for (std::size_t e = 0; e < box.edges().size(); ++e) {
    const std::vector<FaceId>& faces = box.edges()[e].faces;
    const bool used = std::find(faces.begin(), faces.end(), FaceId(2)) != faces.end();
    EXPECT_EQ(d.edges[e].nodes.empty(), !used);
  }
  int vertices = 0;
  for (const BoundaryNode& node : d.nodes) vertices += node.vertex.valid();
  EXPECT_EQ(vertices, 4);
}

TEST(Discretization, AnAbsurdSizeIsRefusedByName) {
  const Model box = model_of(BRepPrimAPI_MakeBox(4, 5, 6).Shape());
  try {
    cut(box, settings_of(1e-9));
    FAIL();
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("size"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Edge1"), std::string::npos);
  }
}

}  // namespace
}  // namespace advlayers
