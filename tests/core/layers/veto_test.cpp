// One small mesh for each geometric veto, and for the link condition: who is refused, and why.
#include <gtest/gtest.h>

#include "base/angles.h"
#include "layers/reconnect.h"
#include "mesh_fixtures.h"

namespace advlayers::test {
namespace {

int counted(const VetoTally& tally, Veto veto) { return tally[static_cast<std::size_t>(veto)]; }

//     c        The pair of triangles beside the edge from a = (0, 0) to b = (width, 0).
//   a - b
//     d
SurfaceMesh pair_beside(double width, const VertexData& c, const VertexData& d) {
  SurfaceMesh mesh;
  mesh.add_vertex(flat_vertex(0.0, 0.0));
  mesh.add_vertex(flat_vertex(width, 0.0));
  mesh.add_vertex(c);
  mesh.add_vertex(d);
  mesh.build({{VertexH(0), VertexH(1), VertexH(2)}, {VertexH(1), VertexH(0), VertexH(3)}});
  return mesh;
}

HalfedgeH middle_of(const SurfaceMesh& mesh) { return mesh.find_halfedge(VertexH(0), VertexH(1)); }

VertexData leaning(double x, double y, double degrees) {
  VertexData data = flat_vertex(x, y);
  data.normal = Vec3(std::sin(degrees * kDegree), 0.0, std::cos(degrees * kDegree));
  return data;
}

// Four triangles about a vertex, the last: its neighbours at (±1, 0) and (0, ±y), `lowered`.
SurfaceMesh pyramid(double y, double lowered) {
  SurfaceMesh mesh;
  for (const auto& [px, py, pz] : {std::array{1.0, 0.0, 0.0}, std::array{0.0, y, -lowered},
                                   std::array{-1.0, 0.0, 0.0}, std::array{0.0, -1.0, -lowered}}) {
    VertexData data = flat_vertex(px, py);
    data.point.xyz.z() = pz;
    mesh.add_vertex(data);
  }
  const VertexH top = mesh.add_vertex(flat_vertex(0.0, 0.0));
  std::vector<std::vector<VertexH>> faces;
  for (int k = 0; k < 4; ++k) faces.push_back({VertexH(k), VertexH((k + 1) % 4), top});
  mesh.build(faces);
  return mesh;
}
constexpr int kTop = 4;

TEST(Veto, InvertsWhereTheTwoTrianglesAreNotConvex) {
  const SurfaceMesh mesh = pair_beside(2.0, flat_vertex(3.0, 0.5), flat_vertex(3.0, -0.5));
  EXPECT_EQ(orientation_veto(mesh, middle_of(mesh)), Veto::kInverts);
  EXPECT_EQ(quality_veto(mesh, middle_of(mesh), {}), Veto::kInverts);
}

TEST(Veto, LowersQualityWhereTheDiagonalIsTheShorterOne) {
  const SurfaceMesh mesh = pair_beside(1.0, flat_vertex(0.5, 0.9), flat_vertex(0.5, -0.9));
  EXPECT_EQ(orientation_veto(mesh, middle_of(mesh)), Veto::kNone);
  EXPECT_EQ(quality_veto(mesh, middle_of(mesh), {}), Veto::kLowersQuality);
}

TEST(Veto, LeavesSurfaceWhereTheNewTrianglesLieAslant) {
  const SurfaceMesh flat = pair_beside(4.0, flat_vertex(2.0, 1.0), flat_vertex(2.0, -1.0));
  EXPECT_EQ(quality_veto(flat, middle_of(flat), {}), Veto::kNone);
  const SurfaceMesh bent = pair_beside(4.0, leaning(2.0, 1.0, 60.0), leaning(2.0, -1.0, 60.0));
  EXPECT_EQ(quality_veto(bent, middle_of(bent), {}), Veto::kLeavesSurface);
}

TEST(Veto, TooSharpWhereACollapseFoldsItsTriangles) {
  ReconnectLimits limits;
  limits.dihedral = 5.0;
  VetoTally tally{};
  SurfaceMesh flat = pyramid(1.0, 0.0);
  EXPECT_TRUE(remove_core_vertex(flat, VertexH(kTop), Removal::kGuarded, limits, tally));
  EXPECT_EQ(counted(tally, Veto::kTooSharp), 0);
  SurfaceMesh roof = pyramid(1.0, 0.1);  // folds by 11 degrees
  EXPECT_FALSE(remove_core_vertex(roof, VertexH(kTop), Removal::kGuarded, limits, tally));
  EXPECT_EQ(counted(tally, Veto::kTooSharp), 4);
}

TEST(Veto, AreaRatioWhereACollapseLeavesATriangleTooSmallBesideAnother) {
  ReconnectLimits limits;
  limits.area_ratio = 5.0;
  VetoTally tally{};
  SurfaceMesh mesh = pyramid(0.1, 0.0);
  EXPECT_TRUE(remove_core_vertex(mesh, VertexH(kTop), Removal::kGuarded, limits, tally));
  EXPECT_EQ(counted(tally, Veto::kAreaRatio), 2);  // onto the two ends of the axis at y = 0
  EXPECT_TRUE(mesh.find_halfedge(VertexH(1), VertexH(3)).valid());
}

TEST(Veto, LinkWhereACollapseWouldFlattenANeighbour) {
  SurfaceMesh mesh = triangle_grid(1, 1);
  const VertexH a = VertexH(0), b = VertexH(1);
  const VertexH v = mesh.split_face(FaceH(0), centroid_of(mesh, FaceH(0)));
  const FaceH below = mesh.face(mesh.find_halfedge(a, b));
  const VertexH u = mesh.split_face(below, centroid_of(mesh, below));
  ASSERT_EQ(mesh.valence(u), 3);
  EXPECT_EQ(mesh.collapse_veto(mesh.find_halfedge(v, a)), Veto::kLink);
  EXPECT_EQ(mesh.collapse_veto(mesh.find_halfedge(u, a)), Veto::kNone);
}

}  // namespace
}  // namespace advlayers::test
