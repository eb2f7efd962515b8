// The trimmed region of one face in its (u, v), as polygons: cheap tests of what lies inside.
#pragma once

#include <functional>
#include <vector>

#include "geometry/model.h"

namespace advlayers {

class FaceDomain {
 public:
  // `uv_at` gives a co-edge's (u, v) at a parameter of its edge.
  using UvAt = std::function<Vec2(const CoEdge&, double)>;
  FaceDomain(const Model& model, const Face& face, const UvAt& uv_at);

  // Whole periods are added to p as needed to meet the region.
  bool contains(Vec2 p) const;
  // The segments of the boundary: where each begins on which co-edge.
  struct Segment {
    Vec2 a, b;
    CoEdge coedge;
    double t_a, t_b;
  };
  const std::vector<Segment>& segments() const { return segments_; }

 private:
  void add(const CoEdge& coedge, double t_a, double t_b, const Vec2& a, const Vec2& b,
           const UvAt& uv_at, int depth);
  bool inside_polygons(const Vec2& p) const;
  void build_bands();

  const Face* face_;
  Vec2 scale_, lo_, hi_;
  std::vector<Segment> segments_;
  // Segments by bands of v, so that a test meets only those beside the point.
  std::vector<std::vector<int>> bands_;
};

}  // namespace advlayers
