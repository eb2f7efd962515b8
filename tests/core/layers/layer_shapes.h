// Faces that the layers are tried on: plane with corners of every class, and curved ones.
#pragma once

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Circ.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>
#include <vector>

namespace advlayers::test {

using Outline = std::vector<std::pair<double, double>>;

inline TopoDS_Wire outline_wire(const Outline& outline) {
  BRepBuilderAPI_MakePolygon polygon;
  for (const auto& [x, y] : outline) polygon.Add(gp_Pnt(x, y, 0));
  polygon.Close();
  return polygon.Wire();
}

// A plane face inside a counter-clockwise outline.
inline TopoDS_Face polygon_face(const Outline& outline) {
  return BRepBuilderAPI_MakeFace(gp_Pln(), outline_wire(outline)).Face();
}

inline TopoDS_Face rectangle(double width, double height) {
  return polygon_face({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

inline TopoDS_Face l_shape() {
  return polygon_face({{0, 0}, {10, 0}, {10, 5}, {5, 5}, {5, 10}, {0, 10}});
}

inline TopoDS_Wire circle_wire(double x, double y, double radius) {
  const gp_Circ circle(gp_Ax2(gp_Pnt(x, y, 0), gp_Dir(0, 0, 1)), radius);
  return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(circle).Edge()).Wire();
}

inline TopoDS_Face disc(double radius) {
  return BRepBuilderAPI_MakeFace(gp_Pln(), circle_wire(0, 0, radius)).Face();
}

// A plate with a round hole and a square one.
inline TopoDS_Face plate_with_holes() {
  BRepBuilderAPI_MakeFace face(gp_Pln(), outline_wire({{0, 0}, {16, 0}, {16, 10}, {0, 10}}));
  face.Add(TopoDS::Wire(circle_wire(4.5, 5, 2).Reversed()));
  face.Add(TopoDS::Wire(outline_wire({{9, 3.5}, {12, 3.5}, {12, 6.5}, {9, 6.5}}).Reversed()));
  return face.Face();
}

// Corners of 27, 110, 250, and a few other degrees.
inline TopoDS_Face sharp_polygon() {
  return polygon_face({{0, 0}, {14, 0}, {17, 5}, {12, 9}, {10, 5}, {6, 8}, {3, 9}, {4, 2}});
}

// A plate with a notch that ends in a point: the face turns by 340 degrees about it.
inline TopoDS_Face notched_plate() {
  const double half = 5 * std::tan(10 * M_PI / 180);
  return polygon_face({{0, 0}, {10, 0}, {10, 10}, {5 + half, 10}, {5, 5}, {5 - half, 10}, {0, 10}});
}

inline TopoDS_Face cylinder_side(double radius, double length) {
  return BRepBuilderAPI_MakeFace(gp_Cylinder(gp_Ax3(), radius), 0, 2 * M_PI, 0, length).Face();
}

// A cone of 20 degrees' half angle, cut off below and above.
inline TopoDS_Face cone_side() {
  return BRepBuilderAPI_MakeFace(gp_Cone(gp_Ax3(), 20 * M_PI / 180, 3), 0, 2 * M_PI, 0, 6).Face();
}

inline TopoDS_Face half_sphere(double radius) {
  return BRepBuilderAPI_MakeFace(gp_Sphere(gp_Ax3(), radius), 0, 2 * M_PI, 0, 0.5 * M_PI).Face();
}

inline TopoDS_Face saddle() {
  TColgp_Array2OfPnt points(1, 7, 1, 7);
  for (int i = 1; i <= 7; ++i) {
    for (int j = 1; j <= 7; ++j) {
      const double x = 2.0 * (i - 4), y = 2.0 * (j - 4);
      points.SetValue(i, j, gp_Pnt(x, y, 0.04 * (x * x - y * y)));
    }
  }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-6).Face();
}

inline TopoDS_Face extruded_spline() {
  TColgp_Array1OfPnt points(1, 6);
  for (int i = 1; i <= 6; ++i) points.SetValue(i, gp_Pnt(2.5 * i, 1.5 * std::sin(1.2 * i), 0));
  const Handle(Geom_BSplineCurve) curve = GeomAPI_PointsToBSpline(points).Curve();
  const gp_Vec along(0, 1, 7);
  return TopoDS::Face(BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeEdge(curve).Edge(), along).Shape());
}

inline TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Trsf& motion) {
  return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

}  // namespace advlayers::test
