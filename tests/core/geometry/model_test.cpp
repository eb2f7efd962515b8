#include "geometry/model.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Plane.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Pln.hxx>

#include <cmath>

#include "base/error.h"
#include "geometry/shapes.h"

namespace advlayers {
namespace {

using test::brep_text;
using test::model_of;

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(gp_Pnt(1, 2, 3), 4, 5, 6).Shape(); }
TopoDS_Shape cylinder() { return BRepPrimAPI_MakeCylinder(2, 5).Shape(); }
TopoDS_Shape cone() { return BRepPrimAPI_MakeCone(3, 0, 4).Shape(); }
TopoDS_Shape frustum() { return BRepPrimAPI_MakeCone(1, 3, 4).Shape(); }
TopoDS_Shape sphere() { return BRepPrimAPI_MakeSphere(2.5).Shape(); }
TopoDS_Shape torus() { return BRepPrimAPI_MakeTorus(5, 1).Shape(); }
TopoDS_Shape drilled() {
  const gp_Ax2 axis(gp_Pnt(3, 4, 2), gp_Dir(0, 0, 1));
  return BRepAlgoAPI_Cut(box(), BRepPrimAPI_MakeCylinder(axis, 1, 10).Shape()).Shape();
}
// A ball with a hole across: its boundary does not follow the sphere's own parameter lines.
TopoDS_Shape pierced_sphere() {
  const gp_Ax2 axis(gp_Pnt(0.5, -5, 0.3), gp_Dir(0.1, 1, 0.2));
  return BRepAlgoAPI_Cut(sphere(), BRepPrimAPI_MakeCylinder(axis, 0.8, 12).Shape()).Shape();
}

TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& trsf) {
  return BRepBuilderAPI_Transform(shape, trsf).Shape();
}

gp_Trsf turn() {
  gp_Trsf trsf;
  trsf.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
  return trsf;
}

gp_Trsf mirror() {
  gp_Trsf trsf;
  trsf.SetMirror(gp_Ax2(gp_Pnt(0.3, 0.2, 0.1), gp_Dir(1, 2, 3)));
  return trsf;
}

// A mirror kept as a location, as some writers leave it, instead of new geometry.
TopoDS_Shape mirrored_in_place(TopoDS_Shape shape) {
  shape.Location(TopLoc_Location(mirror()), Standard_False);
  return shape;
}

struct Case {
  const char* name;
  TopoDS_Shape shape;
};

std::vector<Case> solids() {
  std::vector<Case> cases{{"box", box()},         {"cylinder", cylinder()},     {"cone", cone()},
                          {"frustum", frustum()}, {"sphere", sphere()},         {"torus", torus()},
                          {"drilled", drilled()}, {"pierced", pierced_sphere()}};
  const std::size_t plain = cases.size();
  for (std::size_t i = 0; i < plain; ++i) {
    const TopoDS_Shape shape = cases[i].shape;
    cases.push_back({cases[i].name, transformed(shape, turn())});
    cases.push_back({cases[i].name, transformed(shape, mirror())});
    cases.push_back({cases[i].name, mirrored_in_place(shape)});
  }
  return cases;
}

// Steps off the middle of each co-edge along normal x direction of travel.
void expect_material_on_the_left(const Model& model, const std::string& name) {
  Evaluator evaluator(model);
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    const Face& face = model.faces()[f];
    ASSERT_EQ(face.defect.english(), "") << name;
    for (const auto& loop : face.loops) {
      for (const CoEdge& coedge : loop) {
        if (coedge.degenerate) continue;
        const Edge& edge = model.edge(coedge.edge);
        const double t = edge.first + 0.37 * (edge.last - edge.first);
        const Vec2 uv = evaluator.edge_uv(FaceId(f), coedge, t);
        const SurfaceFrame frame = evaluator.frame(FaceId(f), uv.x(), uv.y());
        const Vec3 travel =
            evaluator.edge_tangent(coedge.edge, t).normalized() * (coedge.forward ? 1.0 : -1.0);
        const Vec3 left = frame.normal.cross(travel);
        // In (u, v): across a seam the far side would be material as well.
        Eigen::Matrix<double, 3, 2> jacobian;
        jacobian << frame.du, frame.dv;
        const Vec2 step = jacobian.colPivHouseholderQr().solve(1e-3 * left);
        const Vec2 middle(0.5 * (face.u_min + face.u_max), 0.5 * (face.v_min + face.v_max));
        const std::string where = name + " " + face_name(FaceId(f)) + " " + edge_name(coedge.edge);
        EXPECT_TRUE(evaluator.inside(FaceId(f), uv.x() + step.x(), uv.y() + step.y())) << where;
        if (coedge.seam) {
          EXPECT_GT(step.dot(middle - uv), 0.0) << where;
        } else {
          EXPECT_FALSE(evaluator.inside(FaceId(f), uv.x() - step.x(), uv.y() - step.y())) << where;
        }
      }
    }
  }
}

TEST(Model, LoopsKeepMaterialOnTheLeftAgainstTheOutwardNormal) {
  for (const Case& c : solids()) {
    expect_material_on_the_left(model_of(c.shape), c.name);
    expect_material_on_the_left(model_of(c.shape.Reversed()), c.name);
  }
}

TEST(Model, OutwardNormalsLeaveTheSolid) {
  for (const Case& c : solids()) {
    const Model model = model_of(c.shape);
    Evaluator evaluator(model);
    BRepClass3d_SolidClassifier classifier(c.shape);
    // To the classifier a solid mirrored in place is inside out; the far away stays outside.
    classifier.PerformInfinitePoint(1e-9);
    const TopAbs_State outside = classifier.State();
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      const Face& face = model.faces()[f];
      for (double a = 0.05; a < 1.0; a += 0.1) {
        const double u = face.u_min + a * (face.u_max - face.u_min);
        const double v = face.v_min + (1.03 - a) * (face.v_max - face.v_min);
        if (!evaluator.inside(FaceId(f), u, v)) continue;
        const SurfaceFrame frame = evaluator.frame(FaceId(f), u, v);
        const Vec3 off = frame.xyz + 1e-3 * frame.normal;
        classifier.Perform(gp_Pnt(off.x(), off.y(), off.z()), 1e-9);
        EXPECT_EQ(classifier.State(), outside) << c.name << " Face" << f + 1;
      }
    }
  }
}

TEST(Model, LoopsAreClosedInTheParameterPlaneAndInSpace) {
  for (const Case& c : solids()) {
    const Model model = model_of(c.shape);
    Evaluator evaluator(model);
    for (std::size_t f = 0; f < model.faces().size(); ++f) {
      const Face& face = model.faces()[f];
      for (const auto& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          const CoEdge& a = loop[i];
          const CoEdge& b = loop[(i + 1) % loop.size()];
          const Edge& ea = model.edge(a.edge);
          const Edge& eb = model.edge(b.edge);
          EXPECT_EQ(a.forward ? ea.end : ea.start, b.forward ? eb.start : eb.end) << c.name;
          const Vec2 end = evaluator.edge_uv(FaceId(f), a, a.forward ? ea.last : ea.first);
          const Vec2 begin = evaluator.edge_uv(FaceId(f), b, b.forward ? eb.first : eb.last);
          EXPECT_LT((end - begin).norm(), 1e-6) << c.name << " " << face_name(FaceId(f));
        }
      }
    }
  }
}

TEST(Model, SolidsAreClosed) {
  for (const Case& c : solids()) {
    const Model model = model_of(c.shape);
    EXPECT_TRUE(model.closed()) << c.name;
    EXPECT_GT(model.diagonal(), 0.0);
  }
}

TEST(Model, AreasAndLengthsAreThoseOfThePrimitives) {
  const Model round = model_of(cylinder());
  double area = 0.0;
  for (const Face& face : round.faces()) area += face.area;
  EXPECT_NEAR(area, 2 * M_PI * 2 * 5 + 2 * M_PI * 4, 1e-9);
  for (const Edge& edge : round.edges()) {
    EXPECT_NEAR(edge.length, edge.start == edge.end ? 4 * M_PI : 5.0, 1e-9);
  }
  EXPECT_NEAR(model_of(box()).diagonal(), std::sqrt(16 + 25 + 36), 1e-6);
}

TEST(Model, DihedralAnglesTellSharpEdgesFromSeams) {
  const Model cube = model_of(box());
  for (std::size_t e = 0; e < cube.edges().size(); ++e) {
    EXPECT_NEAR(cube.dihedral_angle(EdgeId(e)), M_PI / 2, 1e-12);
  }
  const Model round = model_of(cylinder());
  for (std::size_t e = 0; e < round.edges().size(); ++e) {
    const Edge& edge = round.edges()[e];
    const double expected = edge.start == edge.end ? M_PI / 2 : 0.0;
    EXPECT_NEAR(round.dihedral_angle(EdgeId(e)), expected, 1e-9);
  }
  const Model ball = model_of(sphere());
  for (std::size_t e = 0; e < ball.edges().size(); ++e) {
    EXPECT_NEAR(ball.dihedral_angle(EdgeId(e)), 0.0, 1e-6);
  }
}

TEST(Model, FreeAndManifoldEdgesAreToldApart) {
  const Model sheet = model_of(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 2, 0, 1).Shape());
  EXPECT_FALSE(sheet.closed());
  for (std::size_t e = 0; e < sheet.edges().size(); ++e) {
    EXPECT_EQ(sheet.edges()[e].faces.size(), 1u);
    EXPECT_EQ(sheet.dihedral_angle(EdgeId(e)), M_PI);
  }
}

TEST(Model, PolesAreDegenerateEdges) {
  const Model ball = model_of(sphere());
  int poles = 0;
  for (const Edge& edge : ball.edges()) {
    if (!edge.degenerate) continue;
    ++poles;
    EXPECT_EQ(edge.start, edge.end);
    EXPECT_EQ(edge.length, 0.0);
  }
  EXPECT_EQ(poles, 2);
}

TEST(Model, FaceListedTwiceIsOneFace) {
  TopExp_Explorer face(box(), TopAbs_FACE);
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, face.Current());
  builder.Add(both, face.Current().Reversed());
  EXPECT_EQ(model_of(both).faces().size(), 1u);
}

TEST(Model, FaceWithoutWireIsADefectNotAnError) {
  TopoDS_Face bare;
  BRep_Builder builder;
  builder.MakeFace(bare, new Geom_Plane(gp_Pln()), 1e-7);
  TopoDS_Compound both;
  builder.MakeCompound(both);
  builder.Add(both, box());
  builder.Add(both, bare);
  const Model model = model_of(both);
  ASSERT_EQ(model.faces().size(), 7u);
  for (std::size_t f = 0; f < 6; ++f) EXPECT_EQ(model.faces()[f].defect.english(), "");
  EXPECT_NE(model.faces()[6].defect.english(), "");
  EXPECT_TRUE(model.faces()[6].loops.empty());
}

TEST(Model, RefusesWhatIsNoShape) {
  EXPECT_THROW(read_brep(RunContext(), ""), InvalidInput);
  EXPECT_THROW(read_brep(RunContext(), "garbage"), InvalidInput);
  EXPECT_THROW(read_brep(RunContext(), "CASCADE Topology V1, (c) Matra-Datavision\n"),
               InvalidInput);
  TopExp_Explorer edge(box(), TopAbs_EDGE);
  EXPECT_THROW(model_of(edge.Current()), GeometryError);
}

TEST(Model, NamesAreFreeCads) {
  EXPECT_EQ(face_name(FaceId(2)), "Face3");
  EXPECT_EQ(edge_name(EdgeId(6)), "Edge7");
}

}  // namespace
}  // namespace advlayers
