// The surface under one patch, as the front sees it: one smooth surface, whichever CAD face a point
// lies on. A point that leaves its face over an edge inside the patch continues on the neighbour;
// over any other edge it stays on the face's own surface, which is not trimmed.
#pragma once

#include <utility>
#include <vector>

#include "geometry/evaluator.h"
#include "geometry/patch_edges.h"

namespace advlayers {

class PatchSurface {
 public:
  PatchSurface(Evaluator& evaluator, std::vector<FaceId> faces, const FeatureRule& rule = 20.0);

  const std::vector<FaceId>& faces() const { return faces_; }
  const Model& model() const { return evaluator_->model(); }
  bool has_inner_edges() const { return !crossings_.empty(); }
  // True where all faces are planes that lean against each other, by no more than the rule's angle,
  // or facets of a model of triangles: facets of one surface, whose edges mean nothing.
  bool faceted() const { return faceted_; }
  // The edges between two faces of the patch over which it continues, each once, sorted.
  std::vector<EdgeId> inner_edges() const;

  // The point nearest to `xyz` on the edges over which face `a` continues as `b`.
  struct InnerPoint {
    EdgeId edge;
    SurfacePoint point;   // of `b`
    bool at_end = false;  // of the edge
  };
  // Returns false where there is no such edge.
  bool nearest_between(FaceId a, FaceId b, const Vec3& xyz, InnerPoint& found);
  Vec3 normal(const SurfacePoint& p) { return evaluator_->normal(p); }

  // The foot of `xyz`, from a seed. Returns false where no foot is found near the seed.
  bool project(const Vec3& xyz, const SurfacePoint& seed, SurfacePoint& foot);

  // Brings a point that lies beyond its face's boundary, on that face's own surface, to the nearest
  // face of the patch that holds it. Returns false, and leaves it, where none is found.
  bool settle(SurfacePoint& point);

  // Walks `length` [mm] along the surface from `from`, starting in `direction` (any vector with a
  // part in the tangent plane; need not be a unit vector), as straight as the surface allows.
  // The arc length from `from` to `to` is `length` to 1e-6 relative. Returns false where the
  // direction is the normal's, or the surface itself ends before.
  bool step(const SurfacePoint& from, const Vec3& direction, double length, SurfacePoint& to);

 private:
  // A way from one face over an inner edge onto another.
  struct Crossing {
    FaceId from, onto;
    CoEdge coedge;                     // of `onto`
    mutable std::vector<Vec3> points;  // along the edge, once they are asked for
  };
  void find_crossings(const FeatureRule& rule);
  bool has_facets(const std::vector<EdgeId>& smooth) const;
  // The crossings that leave a face lie side by side.
  std::pair<const Crossing*, const Crossing*> crossings_from(FaceId face) const;
  double sample(EdgeId edge, int i) const;  // parameter of the edge
  const std::vector<Vec3>& points_along(const Crossing& crossing);
  double nearest(const Crossing& crossing, const Vec3& xyz, double& t);
  bool cross(const Crossing& crossing, const Vec3& xyz, double t, SurfacePoint& foot);
  bool lands_inside(const SurfacePoint& from, double length, Vec3& heading, SurfacePoint& to);
  const Crossing* crossing_at(const SurfacePoint& p, double reach, EdgeId not_over, double& t);
  double find_exit(const SurfacePoint& from, const Vec3& heading, double length);

  Evaluator* evaluator_;
  std::vector<FaceId> faces_;
  std::vector<Crossing> crossings_;
  bool faceted_ = false;
};

}  // namespace advlayers
