// The BRep, read once: faces, edges and vertices numbered as FreeCAD numbers them, and what of
// their topology and geometry the mesher asks for. No OpenCASCADE type shows in this header.
#pragma once

#include <array>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "base/run_context.h"
#include "base/sentence.h"
#include "base/types.h"

namespace advlayers {

enum class SurfaceKind { kPlane, kCylinder, kCone, kSphere, kTorus, kOther };

// One run of an edge along a face's boundary. Walking a loop's co-edges in order, each from its
// first to its last point, keeps the face's material on the left as seen against the outward
// normal.
struct CoEdge {
  EdgeId edge;
  bool forward = true;      // along increasing edge parameter
  bool seam = false;        // the face uses this edge twice
  int pcurve = 0;           // which of a seam's two curves in (u, v); 0 otherwise
  bool degenerate = false;  // a pole: one point in space, a segment in (u, v)
  Vec2 uv_shift =
      Vec2::Zero();  // whole periods that make the face's loops meet in one (u, v) sheet
};

struct Face {
  std::vector<std::vector<CoEdge>> loops;  // as wires come; the outer one first where it is known
  bool reversed = false;                   // outward normal is -(Su x Sv)
  SurfaceKind kind = SurfaceKind::kOther;
  double area = 0.0;                                  // [mm^2]
  double tolerance = 0.0;                             // [mm]
  double u_min = 0, u_max = 0, v_min = 0, v_max = 0;  // bounds of the trimmed face
  double u_period = 0.0, v_period = 0.0;              // 0: not closed in that direction
  Sentence defect;  // empty, or why the face cannot be meshed ("no boundary wire", …)
};

struct Edge {
  VertexId start, end;         // at first and last parameter; equal for a closed edge; may be none
  double first = 0, last = 0;  // range of the curve's parameter
  double length = 0.0;         // [mm]
  double tolerance = 0.0;      // [mm]
  bool degenerate = false;
  std::vector<FaceId> faces;  // each face once; more than two: non-manifold
};

struct Vertex {
  Vec3 xyz = Vec3::Zero();
  double tolerance = 0.0;
};

class Model {
 public:
  Model();
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Edge>& edges() const { return edges_; }
  const std::vector<Vertex>& vertices() const { return vertices_; }
  const Face& face(FaceId f) const { return faces_[f.index()]; }
  const Edge& edge(EdgeId e) const { return edges_[e.index()]; }
  const Vertex& vertex(VertexId v) const { return vertices_[v.index()]; }
  double diagonal() const { return diagonal_; }  // of the bounding box [mm]
  bool triangular() const {
    return triangular_;
  }                     // all faces are planar triangles, as of an STL file
  bool closed() const;  // every edge of a face is used by exactly two face sides

  // What the given shape's edge is in the model: itself, but where the shape was sewn. Edges that
  // were joined have all become the same one; one that was cut has become several.
  std::vector<EdgeId> pieces(EdgeId given) const;
  bool sewn() const;
  std::size_t given_edges() const;  // of the given shape; a sewn model may have some more
  // Edges of the given shape that sewing joined to others, and edges of one face side that are
  // left.
  int joined_edges() const;
  int free_edges() const;

  // The angle [rad] between the outward normals of the two face sides at an edge, the largest of
  // several samples: 0 where they continue each other, pi where there are not exactly two. The
  // sides of a seam are its face's own, so that a seam along a crease is told from a smooth one.
  double dihedral_angle(EdgeId e) const;

  struct Shape;  // holds the OpenCASCADE shape; geometry/ only
  const Shape& shape() const { return *shape_; }

 private:
  std::vector<int> side_counts() const;
  friend Model build_model(const RunContext& context, std::unique_ptr<Shape> shape);
  std::unique_ptr<Shape> shape_;
  std::vector<Face> faces_;
  std::vector<Edge> edges_;
  std::vector<Vertex> vertices_;
  double diagonal_ = 0.0;
  bool triangular_ = false;
};

std::string face_name(FaceId f);  // "Face3"
std::string edge_name(EdgeId e);  // "Edge7"

// Reads BREP text, as FreeCAD's Shape.exportBrepToString() gives it. Faces whose edges lie within
// `sew_tolerance` [mm] of each other are joined there; 0: none are.
// Throws InvalidInput if the text is no BREP, GeometryError if it holds no face, and Cancelled.
Model read_brep(const RunContext& context, const std::string& text, double sew_tolerance = 0.0);

// Reads .step .stp .iges .igs .brep .brp .stl by the ending, in any case; lengths come out in mm.
// Sews as read_brep() does. Throws InvalidInput for a missing or unreadable file, GeometryError if
// it holds no face, and Cancelled.
Model read_file(const RunContext& context, const std::string& path, double sew_tolerance = 0.0);

}  // namespace advlayers
