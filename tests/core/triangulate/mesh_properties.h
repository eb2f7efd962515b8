// What every triangulation of a patch has to fulfil, whatever the shape.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "base/angles.h"
#include "geometry/patch_edges.h"
#include "mesh/validate.h"
#include "triangulate/triangulate.h"

namespace advlayers::test {

struct Corners {
  std::array<VertexH, 3> v;
  std::array<Vec3, 3> x;
  Vec3 cross() const { return (x[1] - x[0]).cross(x[2] - x[0]); }
};

inline std::vector<Corners> triangles_of(const SurfaceMesh& mesh) {
  std::vector<Corners> all;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f)) continue;
    const HalfedgeH h = mesh.halfedge(f);
    Corners t;
    t.v = {mesh.from(h), mesh.to(h), mesh.to(mesh.next(h))};
    for (std::size_t k = 0; k < 3; ++k) t.x[k] = mesh.position(t.v[k]);
    all.push_back(t);
  }
  return all;
}

inline double angle_at(const Corners& t, std::size_t k) {
  const Vec3 a = t.x[(k + 1) % 3] - t.x[k], b = t.x[(k + 2) % 3] - t.x[k];
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

inline double area_of(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Corners& t : triangles_of(mesh)) sum += t.cross().norm() / 2;
  return sum;
}

// The smallest angle [rad] that the boundary does not force: corners on the border are left out
// where both sides lie on it.
inline double least_free_angle(const SurfaceMesh& mesh) {
  double least = M_PI;
  for (const Corners& t : triangles_of(mesh)) {
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeH out = mesh.find_halfedge(t.v[k], t.v[(k + 1) % 3]);
      const HalfedgeH in = mesh.find_halfedge(t.v[(k + 2) % 3], t.v[k]);
      if (mesh.frozen(out) && mesh.frozen(in)) continue;
      least = std::min(least, angle_at(t, k));
    }
  }
  return least;
}

// The largest angle [rad] of a triangle's normal against the surface's at the projected centroid.
inline double worst_deviation(const SurfaceMesh& mesh, PatchSurface& surface) {
  double worst = 0;
  for (const Corners& t : triangles_of(mesh)) {
    const Vec3 center = (t.x[0] + t.x[1] + t.x[2]) / 3;
    SurfacePoint foot;
    for (const VertexH v : t.v) {
      if (surface.project(center, mesh.data(v).point, foot)) break;
    }
    const Vec3 normal = surface.normal(foot), cross = t.cross();
    worst = std::max(worst, std::atan2(cross.cross(normal).norm(), cross.dot(normal)));
  }
  return worst;
}

// Border edges are the discretization's segments of the patch's boundary edges, each as often as
// the patch's faces use it, and no other.
inline void expect_border_kept(const SurfaceMesh& mesh, Evaluator& evaluator,
                               const Discretization& cut, const std::vector<FaceId>& faces,
                               double feature_angle) {
  using Key = std::tuple<EdgeId, NodeId, NodeId>;
  std::map<Key, int> expected, found;
  const std::vector<EdgeId> inner = inner_edges(evaluator, faces, feature_angle);
  for (const FaceId f : faces) {
    for (const auto& loop : evaluator.model().face(f).loops) {
      for (const CoEdge& coedge : loop) {
        if (coedge.degenerate || std::binary_search(inner.begin(), inner.end(), coedge.edge))
          continue;
        std::vector<NodeId> nodes = cut.edges[coedge.edge.index()].nodes;
        if (!coedge.forward) std::reverse(nodes.begin(), nodes.end());
        for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
          ++expected[{coedge.edge, nodes[k], nodes[k + 1]}];
        }
      }
    }
  }
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!mesh.alive(h)) continue;
    const bool border = mesh.is_border(h) || mesh.is_border(SurfaceMesh::twin(h));
    ASSERT_EQ(mesh.frozen(h), border);
    ASSERT_EQ(mesh.curve(h).valid(), border);
    if (mesh.is_border(h)) {
      const VertexData &from = mesh.data(mesh.to(h)), &to = mesh.data(mesh.from(h));
      ++found[{mesh.curve(h), from.node, to.node}];
      for (const VertexData* end : {&from, &to}) {
        ASSERT_NE(end->support, Support::kPatch);
        ASSERT_EQ(end->point.xyz, cut.nodes[end->node.index()].xyz);
      }
    }
  }
  EXPECT_EQ(found, expected);
}

// Every vertex lies on the surface at its own (u, v); those of the border within the CAD's
// tolerance.
inline void expect_on_surface(const SurfaceMesh& mesh, Evaluator& evaluator) {
  const double exact = 1e-9 * evaluator.model().diagonal();
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!mesh.alive(v)) continue;
    const VertexData& data = mesh.data(v);
    const SurfaceFrame frame = evaluator.frame(data.point.face, data.point.u, data.point.v);
    const double allowed = data.support == Support::kPatch ? exact : 1e-6 + exact;
    ASSERT_LE((frame.xyz - data.point.xyz).norm(), allowed) << "vertex " << i;
    ASSERT_NEAR(data.normal.norm(), 1, 1e-12);
  }
}

struct Expected {
  double least_angle = 25 * kDegree;
  double deviation = 30 * kDegree;
  double area_error =
      0.0205;  // relative: a chord that turns by 20 degrees cuts off 2.02 % of a disc
};

inline void expect_sound(const Triangulation& made, PatchSurface& surface, Evaluator& evaluator,
                         const Discretization& cut, const Settings& settings, int euler,
                         const Expected& expected = {}) {
  const SurfaceMesh& mesh = made.mesh;
  EXPECT_EQ(find_connectivity_fault(mesh), "");
  EXPECT_EQ(find_inverted_element(mesh), "");
  EXPECT_EQ(euler_number(mesh), euler);
  expect_border_kept(mesh, evaluator, cut, surface.faces(), settings.feature_angle);
  expect_on_surface(mesh, evaluator);
  EXPECT_GE(least_free_angle(mesh) / kDegree, expected.least_angle / kDegree);
  EXPECT_LE(worst_deviation(mesh, surface) / kDegree, expected.deviation / kDegree);
  double area = 0;
  for (const FaceId f : surface.faces()) area += evaluator.model().face(f).area;
  EXPECT_NEAR(area_of(mesh), area, expected.area_error * area);
}

}  // namespace advlayers::test
