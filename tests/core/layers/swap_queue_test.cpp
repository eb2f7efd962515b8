#include <gtest/gtest.h>

#include <random>

#include "layers/reconnect.h"
#include "layers/walled_grid.h"
#include "mesh/triangle_measures.h"

namespace advlayers::test {
namespace {

double least_angle(const SurfaceMesh& mesh) {
  double least = M_PI;
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    if (!mesh.alive(FaceH(i))) continue;
    const HalfedgeH h = mesh.halfedge(FaceH(i));
    least = std::min(least, min_angle(corner(mesh, mesh.from(h)), corner(mesh, mesh.to(h)),
                                      corner(mesh, mesh.to(mesh.next(h)))));
  }
  return least;
}

// Inner vertices are moved about, but never so far that a triangle turns over.
SurfaceMesh shaken_grid(unsigned seed) {
  SurfaceMesh mesh = walled_grid(12, 12);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shift(-0.45, 0.45);
  for (int j = 1; j < 12; ++j) {
    for (int i = 1; i < 12; ++i) {
      Vec3& xyz = mesh.data(at(12, i, j)).point.xyz;
      const Vec3 old = xyz;
      xyz += Vec3(shift(random), shift(random), 0.0);
      if (!find_inverted_element(mesh).empty()) xyz = old;
    }
  }
  return mesh;
}

void queue_all(SwapQueue& queue, const SurfaceMesh& mesh) {
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    if (mesh.alive(FaceH(i))) queue.face_changed(mesh, FaceH(i));
  }
}

class SwapQueueOn : public ::testing::TestWithParam<unsigned> {};

TEST_P(SwapQueueOn, RaisesTheLeastAngleUntilNoSwapPays) {
  SurfaceMesh mesh = shaken_grid(GetParam());
  const double before = least_angle(mesh);
  ReconnectLimits limits;
  VetoTally tally{};
  SwapQueue queue(mesh);
  queue_all(queue, mesh);
  queue.run(limits, tally);
  EXPECT_GE(least_angle(mesh), before);
  EXPECT_VALID(mesh);
  EXPECT_UPRIGHT(mesh);
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    if (!mesh.alive(HalfedgeH(i))) continue;
    EXPECT_NE(quality_veto(mesh, HalfedgeH(i), limits), Veto::kNone);
  }
}

TEST_P(SwapQueueOn, LeavesFrozenEdges) {
  SurfaceMesh mesh = shaken_grid(GetParam());
  freeze_run(mesh, 12, 3, 0, 3, 12);
  std::vector<std::pair<VertexH, VertexH>> kept;
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (mesh.frozen(h)) kept.emplace_back(mesh.from(h), mesh.to(h));
  }
  ReconnectLimits limits;
  VetoTally tally{};
  SwapQueue queue(mesh);
  queue_all(queue, mesh);
  queue.run(limits, tally);
  for (const auto& [a, b] : kept) EXPECT_TRUE(mesh.find_halfedge(a, b).valid());
  EXPECT_VALID(mesh);
  EXPECT_UPRIGHT(mesh);
}

INSTANTIATE_TEST_SUITE_P(Seeds, SwapQueueOn, ::testing::Values(1u, 2u, 3u, 4u, 5u));

}  // namespace
}  // namespace advlayers::test
