// What the model keeps of OpenCASCADE. For the sources of geometry/ alone.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Standard_Failure.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/model.h"

namespace advlayers {

// An edge's curve in a face's (u, v). Its range need not be that of the edge in space.
struct Pcurve {
  EdgeId edge;
  int which = 0;  // as CoEdge::pcurve
  Handle(Geom2d_Curve) curve;
  double first = 0.0, last = 0.0;

  Vec2 at(double t, const Edge& e) const {
    const double span = e.last - e.first;
    const double s = span > 0.0 ? first + (last - first) * ((t - e.first) / span) : first;
    const gp_Pnt2d p = curve->Value(same_range(e) ? t : s);
    return {p.X(), p.Y()};
  }

 private:
  bool same_range(const Edge& e) const { return first == e.first && last == e.last; }
};

struct Model::Shape {
  TopoDS_Shape root;
  TopTools_IndexedMapOfShape faces, edges, vertices;
  std::vector<std::vector<Pcurve>> pcurves;  // by FaceId, sorted by edge and `which`
  std::vector<double> dihedral;              // [rad] by EdgeId
  std::vector<std::vector<EdgeId>> pieces;   // of a sewn shape: by the given one's edges

  const TopoDS_Face& face(FaceId f) const;
  const TopoDS_Edge& edge(EdgeId e) const;
  const Pcurve* pcurve(FaceId f, EdgeId e, int which) const;  // null: there is none
};

inline Vec3 to_vec(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }
inline Vec3 to_vec(const gp_Pnt& p) { return to_vec(p.XYZ()); }
inline Vec3 to_vec(const gp_Vec& p) { return to_vec(p.XYZ()); }
inline gp_Pnt to_pnt(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

// Runs `work`; a Standard_Failure (no std::exception) becomes a GeometryError about `subject`.
template <class Work>
auto translated(const char* subject, Work&& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    const char* text = failure.GetMessageString();
    throw GeometryError("{}: OpenCASCADE failed: {}{}", subject, failure.DynamicType()->Name(),
                        text && *text ? std::string(": ") + text : "");
  }
}

// Maps the shape's entities, unless sewing has done so, and asks for everything the mesher needs of
// them. Throws GeometryError if it holds no face.
Model build_model(const RunContext& context, std::unique_ptr<Model::Shape> shape);

}  // namespace advlayers
