#include "quads/triangle_pairs.h"

#include <gtest/gtest.h>

#include "measure/element_measures.h"
#include "mesh_fixtures.h"
#include "quads/dissection.h"

namespace advlayers {
namespace {

std::vector<VertexH> polygon(SurfaceMesh& mesh, const std::vector<std::array<double, 2>>& corners) {
  std::vector<VertexH> loop;
  for (const auto& [x, y] : corners) loop.push_back(mesh.add_vertex(flat_vertex(x, y)));
  return loop;
}

TEST(Dissection, CutsAStripIntoItsSquares) {
  SurfaceMesh mesh;
  const auto loop = polygon(mesh, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {2, 1}, {1, 1}, {0, 1}});
  const Dissection cut = dissect(mesh, loop, 2.0, 0.2);
  ASSERT_EQ(cut.quads.size(), 3u);
  EXPECT_NEAR(cut.worst, 1.0, 1e-12);
  for (const auto& q : cut.quads) {
    EXPECT_NEAR(quad_quality(mesh, q[0], q[1], q[2], q[3]), 1.0, 1e-12);
  }
}

TEST(Dissection, FindsNothingWhereEveryWayIsWorseOrLongerThanAllowed) {
  SurfaceMesh mesh;
  // All corners of one side lie on a line: the corner between them stays flat in every quad.
  const auto flat = polygon(mesh, {{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  EXPECT_TRUE(dissect(mesh, flat, 3.0, 0.1).quads.empty());
  const auto wide = polygon(mesh, {{0, 0}, {1, 0}, {2, 0}, {2, 3}, {1, 3}, {0, 3}});
  EXPECT_EQ(dissect(mesh, wide, 3.5, 0.2).quads.size(), 2u);
  EXPECT_TRUE(dissect(mesh, wide, 2.5, 0.2).quads.empty());
}

// Two triangles and a quad between a layer of three quads and one edge: see triangle_pairs.h.
struct Strip {
  SurfaceMesh mesh;
  std::vector<VertexH> p, x, t;

  explicit Strip(int layer) {
    for (int k = 0; k < 4; ++k) p.push_back(mesh.add_vertex(flat_vertex(k, 0.0)));
    for (int k = 0; k < 4; ++k) {
      x.push_back(mesh.add_vertex(flat_vertex(k, 0.6)));
      mesh.data(x.back()).layer = layer;
      mesh.data(x.back()).parent = p[static_cast<std::size_t>(k)];
    }
    for (const double at : {0.9, 2.1}) t.push_back(mesh.add_vertex(flat_vertex(at, 1.2)));
    const auto beside = polygon(mesh, {{-1, 0}, {-1, 0.6}, {-1, 1.2}, {4, 0}, {4, 0.6}, {4, 1.2}});
    mesh.build({{p[0], p[1], x[1], x[0]},
                {p[1], p[2], x[2], x[1]},
                {p[2], p[3], x[3], x[2]},
                {x[0], x[1], t[0]},
                {x[1], x[2], t[1], t[0]},
                {x[2], x[3], t[1]},
                {beside[0], p[0], x[0], beside[1]},
                {beside[1], x[0], t[0], beside[2]},
                {p[3], beside[3], beside[4], x[3]},
                {x[3], beside[4], beside[5], t[1]}});
    for (std::size_t f = 0; f < 3; ++f) mesh.data(FaceH(f)).layer = layer;
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      const VertexH a = mesh.from(h), b = mesh.to(h);
      if (mesh.data(a).layer == layer && mesh.data(b).layer == layer) mesh.set_frozen(h, true);
    }
  }
  int triangles() const {
    int n = 0;
    for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
      n += mesh.alive(FaceH(i)) && mesh.degree(FaceH(i)) == 3;
    }
    return n;
  }
};

TEST(TrianglePairs, GoWithTheQuadsOfTheLastLayerThatStandInTheWay) {
  Strip strip(8);
  ASSERT_EQ(strip.triangles(), 2);
  EXPECT_EQ(close_triangle_pairs(RunContext(), strip.mesh), 1);
  EXPECT_EQ(strip.triangles(), 0);
  EXPECT_VALID(strip.mesh);
  EXPECT_UPRIGHT(strip.mesh);
}

TEST(TrianglePairs, LeaveTheFirstLayersAlone) {
  Strip strip(1);
  EXPECT_EQ(close_triangle_pairs(RunContext(), strip.mesh), 0);
  EXPECT_EQ(strip.triangles(), 2);
}

TEST(TrianglePairs, LeaveLayersAloneThatAreToStay) {
  Strip strip(8);
  EXPECT_EQ(close_triangle_pairs(RunContext(), strip.mesh, LayerCells::kStay), 0);
  EXPECT_EQ(strip.triangles(), 2);
}

}  // namespace
}  // namespace advlayers
