// Constrained Delaunay triangulation of points and segments in the plane, and the region inside
// closed loops of segments. Points are inserted along a Hilbert curve, with Lawson's flips;
// segments are recovered by flips (Sloan, A fast algorithm for generating constrained Delaunay
// triangulations, 1993). Orientation is decided exactly, so no input breaks the triangulation.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "triangulate/planar_triangulation.h"

namespace advlayers {

class ConstrainedDelaunay {
 public:
  // The Delaunay triangulation of the points, inside a box well outside of them. Vertex i is
  // point i; equal points share the vertex of the first of them. Throws Cancelled, and InvalidInput
  // where a coordinate is not finite.
  ConstrainedDelaunay(const RunContext& context, const std::vector<Vec2>& points);

  // The vertex that stands for point i.
  int vertex(int i) const { return alias_[static_cast<std::size_t>(i)]; }

  // What kept a segment from being one edge of its own; marks are those of the earlier segments.
  struct Conflict {
    int crossed = -1;   // mark of a segment that it crosses: it was not inserted
    int overlaps = -1;  // mark of a segment that one of its edges belongs to already
    int through = -1;   // a vertex inside the segment: it became a chain of edges
    bool none() const { return crossed < 0 && overlaps < 0 && through < 0; }
  };
  // Makes the segment from vertex a to vertex b a chain of edges that no flip removes. The region
  // that carve() keeps lies on its left. `mark` >= 0 is the caller's name for it.
  Conflict constrain(int a, int b, int mark);

  struct Windings {
    int lowest = 0, highest = 0;
  };
  // Removes all triangles about which the segments do not wind counter-clockwise, and the box.
  // Proper loops wind 0 or 1 times about every triangle; `Windings` tells if they did. A segment
  // used once in each direction (a slit) keeps both its sides. Afterwards the mesh's segments are
  // the caller's marks; nothing may be constrained any more.
  Windings carve(const RunContext& context);

  const PlanarTriangulation& mesh() const { return mesh_; }
  PlanarTriangulation release() { return std::move(mesh_); }

 private:
  using Side = PlanarTriangulation::Side;
  struct Constraint {
    int from, to, mark;
    int net;  // times used from -> to, less times used to -> from
  };
  struct Location {
    int t;
    int vertex = -1;  // the point lies on this vertex
    int side = -1;    // or on this side of t
  };
  struct Path {
    std::vector<std::array<int, 2>> crossed;  // edges, first end right of the segment
    int end = -1;                             // vertex that the way ends in
    int blocked = -1;                         // mark of a constraint in the way
  };

  void add_box(const std::vector<Vec2>& points);
  Location locate(const Vec2& p, int hint);
  Location classify(int t, const Vec2& p) const;
  int insert(int v, int hint);
  Path path(int a, int b) const;
  void recover(int a, int b, const std::vector<std::array<int, 2>>& crossed);
  void mark_edge(int a, int b, int mark, Conflict& conflict);
  bool wants_flip(Side s) const;

  PlanarTriangulation mesh_;
  std::vector<int> alias_;
  std::vector<Constraint> constraints_;
  std::vector<int> visited_;  // by triangle: stamp of the last walk that came through
  int stamp_ = 0;
  std::vector<Side> pending_;
};

}  // namespace advlayers
