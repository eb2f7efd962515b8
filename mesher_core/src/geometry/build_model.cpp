#include <BRepAdaptor_Curve.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>

#include "geometry/below_tolerance.h"
#include "geometry/edge_curve.h"
#include "geometry/evaluator.h"
#include "geometry/face_loops.h"
#include "geometry/face_surface.h"
#include "geometry/occt_shape.h"

namespace advlayers {

namespace {

Vertex build_vertex(const TopoDS_Shape& shape) {
  const TopoDS_Vertex& vertex = TopoDS::Vertex(shape);
  return {to_vec(BRep_Tool::Pnt(vertex)), BRep_Tool::Tolerance(vertex)};
}

VertexId find_vertex(const Model::Shape& shape, const TopoDS_Vertex& vertex) {
  return vertex.IsNull() ? VertexId() : VertexId(shape.vertices.FindIndex(vertex) - 1);
}

// An edge without any curve, or of no finite length, keeps an empty parameter range.
Edge build_edge(const Model::Shape& shape, EdgeId id) {
  const TopoDS_Edge edge = TopoDS::Edge(shape.edge(id).Oriented(TopAbs_FORWARD));
  Edge out;
  out.start = find_vertex(shape, TopExp::FirstVertex(edge));
  out.end = find_vertex(shape, TopExp::LastVertex(edge));
  out.tolerance = BRep_Tool::Tolerance(edge);
  out.degenerate = BRep_Tool::Degenerated(edge);
  BRep_Tool::Range(edge, out.first, out.last);
  if (out.degenerate) return out;
  try {
    const BRepAdaptor_Curve curve(edge);
    out.first = curve.FirstParameter();
    out.last = curve.LastParameter();
    const bool finite = !Precision::IsInfinite(out.first) && !Precision::IsInfinite(out.last);
    // GCPnts_AbscissaPoint is off by 1e-3 on a rational B-spline circle.
    if (finite) out.length = EdgeCurve(edge, out, Vec3::Zero()).length_at(out.last);
    if (!finite || !std::isfinite(out.length)) out.last = out.first;
  } catch (const Standard_Failure&) {
    out.last = out.first;
  }
  return out;
}

SurfaceKind kind_of(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Plane:
      return SurfaceKind::kPlane;
    case GeomAbs_Cylinder:
      return SurfaceKind::kCylinder;
    case GeomAbs_Cone:
      return SurfaceKind::kCone;
    case GeomAbs_Sphere:
      return SurfaceKind::kSphere;
    case GeomAbs_Torus:
      return SurfaceKind::kTorus;
    default:
      return SurfaceKind::kOther;
  }
}

// Kind, orientation, closed directions and bounds; false with a defect where there are none.
bool describe_surface(const TopoDS_Face& shape_face, Face& face) {
  gp_Trsf location;
  bool located = false;
  const GeomAdaptor_Surface surface = basis_surface(shape_face, location, located);
  face.kind = kind_of(surface.GetType());
  face.tolerance = BRep_Tool::Tolerance(shape_face);
  // A mirrored location turns Su x Sv over, but not the outside of the solid.
  const bool mirrored = located && location.VectorialPart().Determinant() < 0.0;
  face.reversed = (shape_face.Orientation() == TopAbs_REVERSED) != mirrored;
  if (surface.IsUPeriodic()) {
    face.u_period = surface.UPeriod();
  } else if (surface.IsUClosed()) {
    face.u_period = surface.LastUParameter() - surface.FirstUParameter();
  }
  if (surface.IsVPeriodic()) {
    face.v_period = surface.VPeriod();
  } else if (surface.IsVClosed()) {
    face.v_period = surface.LastVParameter() - surface.FirstVParameter();
  }
  BRepTools::UVBounds(shape_face, face.u_min, face.u_max, face.v_min, face.v_max);
  for (const double x : {face.u_min, face.u_max, face.v_min, face.v_max}) {
    if (std::isfinite(x) && !Precision::IsInfinite(x)) continue;
    face.defect = Sentence("it has no finite bounds");
    return false;
  }
  if (face.u_max > face.u_min && face.v_max > face.v_min) return true;
  face.defect = Sentence("it has no area");
  return false;
}

void measure_area(const TopoDS_Face& shape_face, Face& face) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape_face, properties);
  face.area = std::abs(properties.Mass());
  const bool any = std::isfinite(face.area) && face.area > 0.0;
  if (!any && face.defect.empty()) face.defect = Sentence("it has no area");
}

Face build_face(const Model::Shape& shape, FaceId id, const std::vector<Edge>& edges,
                std::vector<Pcurve>& pcurves) {
  const TopoDS_Face& shape_face = shape.face(id);
  Face face;
  try {
    if (describe_surface(shape_face, face)) {
      build_loops(shape_face, shape, edges, face, pcurves);
      if (face.defect.empty()) measure_area(shape_face, face);
    }
  } catch (const GeometryError& error) {
    face.defect = error.sentence();
  } catch (const Standard_Failure& failure) {
    face.defect = Sentence("OpenCASCADE failed on it: {}", failure.DynamicType()->Name());
  }
  if (!face.defect.empty()) face.loops.clear();
  return face;
}

void list_users(const std::vector<Face>& faces, std::vector<Edge>& edges) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (const auto& loop : faces[f].loops) {
      for (const CoEdge& coedge : loop) {
        std::vector<FaceId>& users = edges[coedge.edge.index()].faces;
        if (users.empty() || users.back() != FaceId(f)) users.push_back(FaceId(f));
      }
    }
  }
}

bool is_triangle(const Face& face) {
  return face.kind == SurfaceKind::kPlane && face.loops.size() == 1 && face.loops[0].size() == 3;
}

// From points on the edges and on curved faces: BRepBndLib takes the poles of B-splines for the
// shape, or, when asked to be exact, as long as reading the file.
double box_diagonal(const RunContext& context, Evaluator& evaluator) {
  const Model& model = evaluator.model();
  Eigen::AlignedBox3d box;
  for (const Vertex& vertex : model.vertices()) box.extend(vertex.xyz);
  constexpr int kOnEdge = 32, kOnFace = 12;  // samples, per direction: the box need not be tight
  for (std::size_t e = 0; e < model.edges().size(); ++e) {
    const Edge& edge = model.edges()[e];
    if (edge.degenerate || !(edge.last > edge.first)) continue;
    for (int k = 0; k <= kOnEdge; ++k) {
      const double t = edge.first + (edge.last - edge.first) * k / kOnEdge;
      box.extend(evaluator.edge_point(EdgeId(e), t));
    }
  }
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    const Face& face = model.faces()[f];
    if (face.kind == SurfaceKind::kPlane || !face.defect.empty()) continue;
    context.check();
    for (int i = 0; i <= kOnFace; ++i) {
      for (int j = 0; j <= kOnFace; ++j) {
        const double u = face.u_min + (face.u_max - face.u_min) * i / kOnFace;
        const double v = face.v_min + (face.v_max - face.v_min) * j / kOnFace;
        if (evaluator.inside(FaceId(f), u, v)) box.extend(evaluator.frame(FaceId(f), u, v).xyz);
      }
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

struct EdgeUse {
  FaceId face;
  CoEdge coedge;
};

double largest_turn(Evaluator& evaluator, EdgeId id, const EdgeUse& a, const EdgeUse& b) {
  const Edge& edge = evaluator.model().edge(id);
  double worst = 0.0;
  constexpr int kSamples = 9;  // along the edge
  for (int k = 0; k < kSamples; ++k) {
    // Away from the ends, where other edges' blends and poles speak.
    const double t = edge.first + (edge.last - edge.first) * (0.02 + 0.96 * k / (kSamples - 1));
    const Vec2 p = evaluator.edge_uv(a.face, a.coedge, t);
    const Vec2 q = evaluator.edge_uv(b.face, b.coedge, t);
    const Vec3 m = evaluator.frame(a.face, p.x(), p.y()).normal;
    const Vec3 n = evaluator.frame(b.face, q.x(), q.y()).normal;
    worst = std::max(worst, std::atan2(m.cross(n).norm(), m.dot(n)));
  }
  return worst;
}

std::vector<double> measure_dihedrals(const RunContext& context, Evaluator& evaluator) {
  const Model& model = evaluator.model();
  std::vector<std::vector<EdgeUse>> uses(model.edges().size());
  for (std::size_t f = 0; f < model.faces().size(); ++f) {
    for (const auto& loop : model.faces()[f].loops) {
      for (const CoEdge& c : loop) uses[c.edge.index()].push_back({FaceId(f), c});
    }
  }
  std::vector<double> angles(model.edges().size(), M_PI);
  for (std::size_t e = 0; e < uses.size(); ++e) {
    context.check();
    if (model.edges()[e].degenerate) {
      angles[e] = 0.0;  // a pole parts nothing
    } else if (uses[e].size() == 2) {
      angles[e] = largest_turn(evaluator, EdgeId(e), uses[e][0], uses[e][1]);
    }
  }
  return angles;
}

}  // namespace

Model build_model(const RunContext& context, std::unique_ptr<Model::Shape> shape) {
  return translated("shape", [&] {
    Model model;
    if (shape->faces.IsEmpty()) {
      TopExp::MapShapes(shape->root, TopAbs_FACE, shape->faces);
      TopExp::MapShapes(shape->root, TopAbs_EDGE, shape->edges);
      TopExp::MapShapes(shape->root, TopAbs_VERTEX, shape->vertices);
    }
    if (shape->faces.IsEmpty()) throw GeometryError("the shape holds no face");
    for (int i = 1; i <= shape->vertices.Extent(); ++i) {
      model.vertices_.push_back(build_vertex(shape->vertices(i)));
    }
    for (int i = 0; i < shape->edges.Extent(); ++i) {
      context.check();
      model.edges_.push_back(build_edge(*shape, EdgeId(i)));
    }
    contract_short_edges(model.vertices_, model.edges_);
    shape->pcurves.resize(static_cast<std::size_t>(shape->faces.Extent()));
    for (int i = 0; i < shape->faces.Extent(); ++i) {
      context.check();
      const FaceId id(i);
      model.faces_.push_back(build_face(*shape, id, model.edges_, shape->pcurves[id.index()]));
    }
    model.shape_ = std::move(shape);
    Evaluator evaluator(model);
    remove_false_poles(evaluator, model.faces_);
    list_users(model.faces_, model.edges_);
    model.triangular_ = std::all_of(model.faces_.begin(), model.faces_.end(), is_triangle);
    model.diagonal_ = box_diagonal(context, evaluator);
    model.shape_->dihedral = measure_dihedrals(context, evaluator);
    return model;
  });
}

}  // namespace advlayers
