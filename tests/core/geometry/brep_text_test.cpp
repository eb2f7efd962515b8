#include "geometry/brep_text.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Hyperbola.hxx>
#include <Geom_OffsetCurve.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Parabola.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Compound.hxx>

#include <random>

#include "base/error.h"
#include "geometry/shapes.h"

namespace advlayers {
namespace {

using test::brep_text;

// One of each kind of curve and surface that the format knows.
TopoDS_Compound everything() {
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(4, 5, 6).Shape();
  const gp_Ax2 axis(gp_Pnt(2, 2, -1), gp_Dir(0, 0.1, 1));
  builder.Add(all, BRepAlgoAPI_Cut(box, BRepPrimAPI_MakeCylinder(axis, 1, 9).Shape()).Shape());
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 0.3)), 0.7);
  builder.Add(all, BRepPrimAPI_MakeCone(3, 0, 4).Shape().Moved(TopLoc_Location(turn)));
  builder.Add(all, BRepPrimAPI_MakeSphere(2).Shape().Reversed());
  builder.Add(all, BRepPrimAPI_MakeTorus(5, 1).Shape());
  builder.Add(all, BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeTorus(5, 2).Shape()).Shape());

  TColgp_Array2OfPnt net(1, 3, 1, 4);
  for (int i = 1; i <= 3; ++i) {
    for (int j = 1; j <= 4; ++j) net(i, j) = gp_Pnt(i, j, 0.3 * i * j);
  }
  const Handle(Geom_Surface) bezier = new Geom_BezierSurface(net);
  TColgp_Array1OfPnt poles(1, 4);
  for (int i = 1; i <= 4; ++i) poles(i) = gp_Pnt(2 + i, 0, i * i);
  const Handle(Geom_Curve) curve = new Geom_BezierCurve(poles);
  const Handle(Geom_Surface) offset = new Geom_OffsetSurface(bezier, 0.2);
  const Handle(Geom_Surface) trimmed =
      new Geom_RectangularTrimmedSurface(bezier, 0.2, 0.7, 0.1, 0.8);
  const Handle(Geom_Curve) part = new Geom_TrimmedCurve(curve, 0.2, 0.9);
  const Handle(Geom_Surface) revolved = new Geom_SurfaceOfRevolution(part, gp::OZ());
  const Handle(Geom_Surface) extruded = new Geom_SurfaceOfLinearExtrusion(part, gp::DY());
  for (const Handle(Geom_Surface) & s : {bezier, offset, trimmed, revolved}) {
    builder.Add(all, BRepBuilderAPI_MakeFace(s, 1e-7).Face());
  }
  builder.Add(all, BRepBuilderAPI_MakeFace(extruded, 0.2, 0.9, 0, 2, 1e-7).Face());
  const gp_Ax2 plane;
  const Handle(Geom_Curve) ellipse = new Geom_Ellipse(plane, 3, 2);
  const Handle(Geom_Curve) parabola = new Geom_Parabola(plane, 2);
  const Handle(Geom_Curve) hyperbola = new Geom_Hyperbola(plane, 2, 3);
  const Handle(Geom_Curve) shifted = new Geom_OffsetCurve(curve, 0.1, gp::DY());
  builder.Add(all, BRepBuilderAPI_MakeEdge(ellipse).Edge());
  builder.Add(all, BRepBuilderAPI_MakeEdge(parabola, -1, 1).Edge());
  builder.Add(all, BRepBuilderAPI_MakeEdge(hyperbola, -1, 1).Edge());
  builder.Add(all, BRepBuilderAPI_MakeEdge(shifted).Edge());
  return all;
}

std::string refusal(const std::string& text) {
  try {
    check_brep_text(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(BrepText, WhatOpenCascadeWritesIsWhole) {
  const TopoDS_Compound all = everything();
  EXPECT_EQ(refusal(brep_text(all)), "");
  EXPECT_GT(read_brep(RunContext(), brep_text(all)).faces().size(), 15u);
  BRepMesh_IncrementalMesh(all, 0.5);
  for (const TopTools_FormatVersion version :
       {TopTools_FormatVersion_VERSION_1, TopTools_FormatVersion_VERSION_2,
        TopTools_FormatVersion_VERSION_3}) {
    for (const bool triangles : {false, true}) {
      std::ostringstream text;
      BRepTools::Write(all, text, triangles, triangles, version);
      EXPECT_EQ(refusal(text.str()), "") << "version " << version << ", triangles " << triangles;
    }
  }
}

TEST(BrepText, LinesMayEndAsOnWindowsAndTheHeaderMayHaveLinesBeforeIt) {
  std::string text = "DBRep_DrawableShape\n" + brep_text(BRepPrimAPI_MakeTorus(5, 1).Shape());
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_brep(RunContext(), text).faces().size(), 1u);
  EXPECT_EQ(read_brep(RunContext(), windows).faces().size(), 1u);
}

TEST(BrepText, NoCutOffTextPasses) {
  const std::string text = brep_text(everything());
  const std::size_t whole = text.find_last_not_of(" \n\r\t") + 1;
  std::mt19937 random(11);
  for (int k = 0; k < 300; ++k) {
    EXPECT_NE(refusal(text.substr(0, random() % (whole - 1))), "");
  }
  EXPECT_NE(refusal(text.substr(0, whole - 1)), "");
}

TEST(BrepText, DamageIsToldWithItsLineAndNeverCrashesTheReader) {
  const std::string text = brep_text(everything());
  const std::string letters = "0123456789 -+.e\nAB*";
  std::mt19937 random(5);
  int refused = 0;
  for (int k = 0; k < 300; ++k) {
    std::string damaged = text;
    for (int i = 0; i < 3; ++i)
      damaged[random() % text.size()] = letters[random() % letters.size()];
    try {
      read_brep(RunContext(), damaged);
    } catch (const InvalidInput& error) {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("the text is no BREP shape"), std::string::npos);
    } catch (const GeometryError&) {
      continue;
    }
  }
  EXPECT_GT(refused, 100);
  std::string out_of_range = text;
  const std::size_t tshapes = out_of_range.find("TShapes ");
  out_of_range.replace(out_of_range.find("\n+", tshapes) + 2, 1, "999999");
  EXPECT_NE(refusal(out_of_range).find("line "), std::string::npos);
}

}  // namespace
}  // namespace advlayers
