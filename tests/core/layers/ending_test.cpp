// How growth ends: by closing, by the limits that were asked for, or by a request to stop. And that
// the result depends on nothing else.
#include <gtest/gtest.h>

#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <array>

#include "base/error.h"
#include "layers/layer_run.h"
#include "layers/layer_shapes.h"

namespace advlayers::test {
namespace {

// Triangles that the layers made, in percent of their elements; the core is none of theirs.
double triangle_percent(const LayerRun& run) {
  int quads = 0, triangles = 0;
  for (const LayerReport& report : run.reports) {
    quads += report.quads;
    triangles += report.triangles;
  }
  return 100.0 * triangles / (quads + triangles);
}

using MeshText = std::vector<std::tuple<int, int, bool, double, double, double>>;
MeshText text_of(const SurfaceMesh& mesh) {
  MeshText text;
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!mesh.alive(h)) continue;
    const Vec3& p = mesh.position(mesh.to(h));
    text.emplace_back(mesh.to(h).value, mesh.face(h).value, mesh.frozen(h), p.x(), p.y(), p.z());
  }
  return text;
}

TEST(Closing, SquaresHaveHardlyATriangle) {
  double left = 0.0, quads = 0.0;
  const std::array<double, 5> sides{8.0, 9.0, 10.0, 11.0, 13.0};
  for (const double side : sides) {
    LayerRun run(rectangle(side, side), {1.0, 0.1, 1.1});
    run.grow();
    left += triangle_percent(run) / sides.size();
    quads += elements_of(run.mesh).quad_percent() / sides.size();
  }
  EXPECT_LE(left, 1.0);
  EXPECT_GE(quads, 99.0);
}

TEST(Closing, ADiscHasFewTriangles) {
  for (const double radius : {4.0, 5.0, 8.0}) {
    LayerRun run(disc(radius), {0.7, 0.07, 1.1});
    run.grow();
    EXPECT_LE(triangle_percent(run), 2.0) << radius;
    EXPECT_GE(elements_of(run.mesh).quad_percent(), 96.0) << radius;
  }
}

// Layers that grow along a thin rod become higher than the edges around it are long; thinned out as
// on a plane, the front would end up as a triangle through the rod.
TEST(Closing, AThinRodStaysRound) {
  LayerRun run(cylinder_side(1.0, 12.0), {1.0, 0.1, 1.3});
  run.walls.max_height = 1.0;
  run.grow();
  for (std::size_t i = 0; i < run.mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!run.mesh.alive(h)) continue;
    const VertexData& from = run.mesh.data(run.mesh.from(h));
    const VertexData& to = run.mesh.data(run.mesh.to(h));
    EXPECT_GT(from.normal.dot(to.normal), 0.5) << from.point.xyz.transpose();
  }
}

// Every column ends for a reason, and each wall vertex is told of.
TEST(Closing, EveryWallVertexHasAReason) {
  LayerRun run(plate_with_holes());
  run.grow();
  std::vector<std::uint8_t> told(run.mesh.vertex_capacity(), 0);
  int noted = 0;
  for (const LayerReport& report : run.reports) {
    for (const int stops : report.stops) noted += stops;
  }
  EXPECT_EQ(noted, static_cast<int>(run.layers().stops().size()));
  for (const StopRecord& record : run.layers().stops()) {
    EXPECT_EQ(run.mesh.data(record.root).layer, 0);
    EXPECT_NE(run.mesh.data(record.root).support, Support::kPatch);
    EXPECT_GE(record.layer, 1);
    told[record.root.index()] = 1;
  }
  for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
    if (!run.mesh.alive(VertexH(i)) || run.mesh.data(VertexH(i)).support == Support::kPatch) {
      continue;
    }
    EXPECT_TRUE(told[i]) << "wall vertex " << i;
  }
}

TEST(Limits, NoMoreLayersThanAsked) {
  for (const int layers : {1, 3}) {
    LayerRun run(cylinder_side(3, 8));
    for (auto& [edge, plan] : run.walls.edges) plan.growth.layers_left = layers;
    run.grow();
    int highest = 0;
    for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
      if (run.mesh.alive(VertexH(i))) highest = std::max(highest, run.mesh.data(VertexH(i)).layer);
    }
    EXPECT_EQ(highest, layers);
    for (const StopRecord& record : run.layers().stops()) {
      EXPECT_EQ(record.reason, Stop::kLayersReached);
      EXPECT_EQ(record.layer, layers + 1);
    }
  }
}

TEST(Limits, ZeroLayersLeaveTriangles) {
  LayerRun run(rectangle(6, 6));
  for (auto& [edge, plan] : run.walls.edges) plan.growth.layers_left = 0;
  run.grow();
  EXPECT_EQ(elements_of(run.mesh).quads, 0);
  EXPECT_EQ(find_connectivity_fault(run.mesh), "");
  EXPECT_EQ(find_inverted_element(run.mesh), "");
}

TEST(Limits, NoLayerIsHigherThanAsked) {
  LayerRun run(cylinder_side(3, 8), {1.0, 0.1, 1.4});
  run.walls.max_height = 0.25;
  run.grow(8);
  double highest = 0.0;
  for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!run.mesh.alive(v) || run.mesh.data(v).layer == 0) continue;
    highest = std::max(highest,
                       (run.mesh.position(v) - run.mesh.position(run.mesh.data(v).parent)).norm());
  }
  EXPECT_NEAR(highest, 0.25, 1e-3);  // reached, never passed
}

TEST(Limits, StopsAtIsotropy) {
  LayerRun run(cylinder_side(3, 30), {1.0, 0.2, 1.2});
  run.walls.stop_at_isotropy = true;
  run.grow();
  const double segment = (run.mesh.position(VertexH(0)) -
                          run.mesh.position(run.mesh.to(run.mesh.outgoing(VertexH(0)))))
                             .norm();
  // The first height of the series 0.2 * 1.2^k that reaches the front's edges, which keep their
  // length on a cylinder, is not made.
  const int layers = static_cast<int>(std::ceil(std::log(segment / 0.2) / std::log(1.2) - 1e-6));
  ASSERT_FALSE(run.layers().stops().empty());
  for (const StopRecord& record : run.layers().stops()) {
    EXPECT_EQ(record.reason, Stop::kIsotropic);
    EXPECT_EQ(record.layer, layers + 1);
  }
}

// Where the last layer asked for is made no way is made for another: the core is as it was left.
TEST(Limits, NothingIsClearedForALayerThatDoesNotCome) {
  LayerRun run(rectangle(20, 10), {0.5, 0.1, 1.2});
  LayerRun longer(rectangle(20, 10), {0.5, 0.1, 1.2});
  for (auto& [edge, plan] : run.walls.edges) plan.growth.layers_left = 8;
  for (auto& [edge, plan] : longer.walls.edges) plan.growth.layers_left = 20;
  run.grow();
  longer.grow(8);
  EXPECT_EQ(run.reports.size(), 8u);
  EXPECT_EQ(text_of(run.mesh), text_of(longer.mesh));
}

TEST(Cancel, BeforeALayer) {
  LayerRun run(plate_with_holes());
  run.grow(2);
  const ElementCount before = elements_of(run.mesh);
  run.context.cancel();
  EXPECT_THROW(run.layers().advance(), Cancelled);
  EXPECT_EQ(find_connectivity_fault(run.mesh), "");
  EXPECT_EQ(find_inverted_element(run.mesh), "");
  EXPECT_TRUE(elements_of(run.mesh) == before);
}

TEST(Cancel, WithinALayerAtAnyStep) {
  for (int at = 0; at < 6; ++at) {
    LayerRun run(plate_with_holes());
    run.grow(1);
    const std::vector<BorderEdge> border = border_of(run.mesh);
    int step = 0;
    run.layers().set_step_hook([&](Step, const SurfaceMesh&) {
      if (step++ == at) run.context.cancel();
    });
    EXPECT_THROW(run.layers().advance(), Cancelled) << "after step " << at;
    EXPECT_EQ(find_connectivity_fault(run.mesh), "");
    EXPECT_EQ(find_inverted_element(run.mesh), "");
    EXPECT_EQ(border_of(run.mesh), border);
  }
}

TEST(Determinism, TwoRunsAreBitwiseEqual) {
  for (const auto& shape : {TopoDS_Shape(plate_with_holes()), TopoDS_Shape(half_sphere(5))}) {
    LayerRun one(shape), other(shape);
    one.grow();
    other.grow();
    EXPECT_EQ(text_of(one.mesh), text_of(other.mesh));
  }
}

class Motions : public ::testing::TestWithParam<const char*> {
 protected:
  gp_Trsf motion() const {
    gp_Trsf t;
    const std::string name = GetParam();
    if (name == "Mirror") t.SetMirror(gp_Ax2(gp_Pnt(3, 0, 0), gp_Dir(1, 0, 0)));
    if (name == "Rotation") t.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 2, -1)), 0.7);
    if (name == "Small") t.SetScale(gp_Pnt(0, 0, 0), 1e-3);
    if (name == "Large") t.SetScale(gp_Pnt(0, 0, 0), 1e3);
    return t;
  }
};

TEST_P(Motions, ChangeNothingThatCounts) {
  for (const auto& shape : {TopoDS_Shape(plate_with_holes()), TopoDS_Shape(sharp_polygon())}) {
    LayerRun plain(shape);
    plain.grow();
    const double scale = std::abs(motion().ScaleFactor());
    LayerRun other(moved(shape, motion()), {scale, 0.1 * scale, 1.2});
    other.grow();
    const ElementCount a = elements_of(plain.mesh), b = elements_of(other.mesh);
    EXPECT_EQ(find_inverted_element(other.mesh), "");
    EXPECT_NEAR(a.quads, b.quads, 0.05 * a.quads);
    // Where fronts meet, last bits decide which of two closings is taken: eight cells of 400 here.
    EXPECT_NEAR(a.quad_percent(), b.quad_percent(), 2.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Motions, ::testing::Values("Mirror", "Rotation", "Small", "Large"));

}  // namespace
}  // namespace advlayers::test
