#include "geometry/torn_shape.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/occt_shape.h"

namespace advlayers {
namespace {

constexpr double kOff = 0.01;  // of the diagonal
constexpr int kSamples = 8;    // along an edge

class Parts {
 public:
  explicit Parts(const TopoDS_Shape& shape) {
    TopExp::MapShapes(shape, TopAbs_FACE, faces_);
    TopExp::MapShapes(shape, TopAbs_EDGE, edges_);
    Bnd_Box box;
    for (TopExp_Explorer vertices(shape, TopAbs_VERTEX); vertices.More(); vertices.Next()) {
      box.Add(BRep_Tool::Pnt(TopoDS::Vertex(vertices.Current())));
    }
    // Of a sphere's two poles, or of a torus, the box says nothing.
    allowed_ = box.IsVoid() ? 0.0 : kOff * std::sqrt(box.SquareExtent());
  }

  void check() const {
    for (int f = 1; f <= faces_.Extent(); ++f) {
      const TopoDS_Face& face = TopoDS::Face(faces_(f));
      if (BRep_Tool::Surface(face).IsNull()) continue;
      const BRepAdaptor_Surface surface(face);
      const double size = refuse_endless(surface, f);
      for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
        const TopoDS_Edge& edge = TopoDS::Edge(edges.Current());
        check_edge(edge, face, surface, std::max(allowed_, kOff * size), f);
      }
    }
  }

 private:
  // The distance between opposite corners of the face's range of parameters.
  static double refuse_endless(const BRepAdaptor_Surface& surface, int f) {
    const double u1 = surface.FirstUParameter(), u2 = surface.LastUParameter();
    const double v1 = surface.FirstVParameter(), v2 = surface.LastVParameter();
    for (const double bound : {u1, u2, v1, v2}) {
      if (Precision::IsInfinite(bound) || !std::isfinite(bound)) {
        throw InvalidInput("it is damaged: {} has no end", face_name(FaceId(f - 1)));
      }
    }
    return std::max(surface.Value(u1, v1).Distance(surface.Value(u2, v2)),
                    surface.Value(u1, v1).Distance(surface.Value((u1 + u2) / 2, (v1 + v2) / 2)));
  }

  void check_edge(const TopoDS_Edge& edge, const TopoDS_Face& face,
                  const BRepAdaptor_Surface& surface, double allowed, int f) const {
    double first = 0, last = 0, first2d = 0, last2d = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    const Handle(Geom2d_Curve) pcurve = BRep_Tool::CurveOnSurface(edge, face, first2d, last2d);
    if (curve.IsNull() || pcurve.IsNull()) return;
    double off = 0.0;
    for (int i = 0; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      const gp_Pnt2d uv = pcurve->Value(first2d + share * (last2d - first2d));
      const gp_Pnt p = curve->Value(first + share * (last - first));
      off = std::max(off, surface.Value(uv.X(), uv.Y()).Distance(p));
    }
    off = std::max(off, ends_off(edge, curve->Value(first), curve->Value(last)));
    if (off <= allowed) return;
    throw InvalidInput("it is damaged: {} lies {} mm off {}",
                       edge_name(EdgeId(edges_.FindIndex(edge) - 1)), off,
                       face_name(FaceId(f - 1)));
  }

  static double ends_off(const TopoDS_Edge& edge, const gp_Pnt& first, const gp_Pnt& last) {
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex start = TopExp::FirstVertex(forward), end = TopExp::LastVertex(forward);
    return std::max(start.IsNull() ? 0.0 : BRep_Tool::Pnt(start).Distance(first),
                    end.IsNull() ? 0.0 : BRep_Tool::Pnt(end).Distance(last));
  }

  TopTools_IndexedMapOfShape faces_, edges_;
  double allowed_ = 0.0;  // [mm]
};

}  // namespace

void refuse_torn_shape(const TopoDS_Shape& shape) { Parts(shape).check(); }

}  // namespace advlayers
