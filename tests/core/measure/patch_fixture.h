// One face of a shape, cut and triangulated: what the core's improvement begins with.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "coarse_settings.h"
#include "geometry/shapes.h"
#include "measure/element_measures.h"
#include "mesh/validate.h"
#include "triangulate/triangulate.h"

namespace advlayers::test {

struct TriangulatedFace {
  TriangulatedFace(const TopoDS_Shape& shape, double size, FaceId face = FaceId(0))
      : model(model_of(shape)), evaluator(model), surface(evaluator, {face}) {
    settings.size = size;
    settings.first_height = size / 10;
    boundary = discretize(context, evaluator, settings);
    mesh = triangulate(context, surface, evaluator, boundary, settings).mesh;
  }

  Model model;
  Evaluator evaluator;
  PatchSurface surface;
  Settings settings = test::coarse_settings();
  RunContext context;
  Discretization boundary;
  SurfaceMesh mesh;
};

struct AngleShares {
  double quads = 0.0, good_angles = 0.0;  // parts of elements, and of angles within 45 ... 135
  double min_angle = 360.0, max_angle = 0.0;
};

inline AngleShares angle_shares(const SurfaceMesh& mesh) {
  AngleShares shares;
  double elements = 0.0, angles = 0.0;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    if (!mesh.alive(FaceH(i))) continue;
    const ElementCorners element = corners_of(mesh, FaceH(i));
    elements += 1.0;
    shares.quads += element.count == 4;
    const auto of_element = interior_angles(element);
    for (std::size_t k = 0; k < static_cast<std::size_t>(element.count); ++k) {
      angles += 1.0;
      shares.good_angles += of_element[k] >= 45.0 && of_element[k] <= 135.0;
      shares.min_angle = std::min(shares.min_angle, of_element[k]);
      shares.max_angle = std::max(shares.max_angle, of_element[k]);
    }
  }
  shares.quads /= elements;
  shares.good_angles /= angles;
  return shares;
}

// Frozen edges by their ends and places, sorted.
inline std::vector<std::tuple<int, int, double, double>> frozen_edges(const SurfaceMesh& mesh) {
  std::vector<std::tuple<int, int, double, double>> edges;
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.frozen(h)) continue;
    edges.emplace_back(mesh.from(h).value, mesh.to(h).value, mesh.position(mesh.from(h)).sum(),
                       mesh.position(mesh.to(h)).sum());
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

inline void expect_sound(TriangulatedFace& face, int euler) {
  EXPECT_EQ(find_connectivity_fault(face.mesh), "");
  EXPECT_EQ(find_inverted_element(face.mesh), "");
  EXPECT_EQ(euler_number(face.mesh), euler);
  const double tolerance = 1e-9 * face.model.diagonal();
  for (std::size_t i = 0; i < face.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!face.mesh.alive(v) || face.mesh.data(v).support != Support::kPatch) continue;
    SurfacePoint foot;
    ASSERT_TRUE(face.surface.project(face.mesh.position(v), face.mesh.data(v).point, foot));
    EXPECT_LT((foot.xyz - face.mesh.position(v)).norm(), tolerance);
  }
}

}  // namespace advlayers::test
