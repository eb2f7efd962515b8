#include "mend/element_faults.h"

#include <BRepPrimAPI_MakeCylinder.hxx>

#include "measure/patch_fixture.h"

namespace advlayers::test {
namespace {

class OnCylinder : public testing::Test {
 protected:
  OnCylinder() : face(BRepPrimAPI_MakeCylinder(2, 5).Shape(), 0.6) {}

  int faults(const FaceCorners& corners) { return faults_of(face.mesh, corners, face.surface); }

  // Of the border at z = 0, in its order.
  std::vector<VertexH> circle() {
    std::vector<VertexH> found;
    for (std::size_t i = 0; i < face.mesh.halfedge_capacity() && found.empty(); ++i) {
      const HalfedgeH first(i);
      if (!face.mesh.is_border(first)) continue;
      for (const HalfedgeH h : face.mesh.sides(first)) found.push_back(face.mesh.from(h));
    }
    return found;
  }

  TriangulatedFace face;
};

TEST_F(OnCylinder, ASoundTriangulationHasNone) {
  for (std::size_t i = 0; i < face.mesh.face_capacity(); ++i) {
    if (!face.mesh.alive(FaceH(i))) continue;
    EXPECT_EQ(faults(corners_around(face.mesh, FaceH(i))), 0);
  }
}

TEST_F(OnCylinder, WhatIsTurnedOverWeighsMoreThanWhatIsSteep) {
  const FaceCorners upright = corners_around(face.mesh, FaceH(0));
  const std::array<VertexH, 3> reversed{upright[0], upright[2], upright[1]};
  EXPECT_NEAR(uprightness(face.mesh, reversed, face.surface), -1.0, 0.1);
  // Three points of one circle: the triangle stands across the surface.
  const std::vector<VertexH> ring = circle();
  ASSERT_GT(ring.size(), 4u);
  const std::array<VertexH, 3> across{ring[0], ring[1], ring[2]};
  EXPECT_NEAR(uprightness(face.mesh, across, face.surface), 0.0, 1e-6);
  // Round-off decides on which side such a triangle stands; one of the two is not turned over.
  const std::array<VertexH, 3> back{ring[0], ring[2], ring[1]};
  EXPECT_GT(std::min(faults(across), faults(back)), 0);
  EXPECT_GE(faults(reversed), std::max(faults(across), faults(back)));
}

TEST_F(OnCylinder, ATriangleAroundHalfThePipeIsBent) {
  const std::vector<VertexH> ring = circle();
  ASSERT_TRUE(face.mesh.is_border(ring[0]));
  // A vertex of the other circle beyond more than a quarter of the turn from both others.
  const VertexH a = ring[0], b = ring[1];
  const Vec3 normal = face.mesh.data(a).normal;
  for (std::size_t i = 0; i < face.mesh.vertex_capacity(); ++i) {
    const VertexH c(i);
    if (!face.mesh.alive(c) || face.mesh.data(c).normal.dot(normal) > -0.9) continue;
    EXPECT_GT(faults(std::array<VertexH, 3>{a, b, c}) + faults(std::array<VertexH, 3>{b, a, c}), 0);
  }
}

}  // namespace
}  // namespace advlayers::test
