// Kids that leave the bisector: towards the nodes of an opposing front, and towards even spacing on
// surfaces that drive columns together or apart.
#include <gtest/gtest.h>

#include <gp_Torus.hxx>

#include "layers/layer_run.h"
#include "layers/layer_shapes.h"

namespace advlayers::test {
namespace {

// A channel whose long sides are cut out of step with each other by `shift`.
TopoDS_Face leaning_channel(double shift) {
  return polygon_face({{0, 0}, {12, 0}, {12 + shift, 2.4}, {shift, 2.4}});
}

// The front edges in the middle of the channel that lie opposite each other, as the x of their
// ends.
std::vector<double> front_places(const LayerRun& run, bool lower) {
  std::vector<double> places;
  for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!run.mesh.alive(v) || run.mesh.data(v).layer != run.reports.back().layer) continue;
    const Vec3& p = run.mesh.position(v);
    if ((p.y() < 1.2) == lower && p.x() > 4.0 && p.x() < 8.0) places.push_back(p.x());
  }
  std::sort(places.begin(), places.end());
  return places;
}

double out_of_step(const LayerRun& run) {
  const auto lower = front_places(run, true), upper = front_places(run, false);
  double worst = 0.0;
  for (const double x : lower) {
    double nearest = 1e9;
    for (const double other : upper) nearest = std::min(nearest, std::abs(x - other));
    worst = std::max(worst, nearest);
  }
  return worst;
}

TEST(Sliding, FrontsComeIntoStepBeforeTheyMeet) {
  for (const double shift : {0.3, 0.5}) {
    LayerRun run(leaning_channel(shift), {1.0, 0.08, 1.05});
    run.grow(5);
    ASSERT_FALSE(front_places(run, true).empty());
    const double at_first = out_of_step(run);
    EXPECT_GT(at_first, 0.9 * shift) << "the first layers grow straight";
    run.grow(5);
    EXPECT_LT(out_of_step(run), 0.4 * at_first) << shift;
  }
}

// The layers keep their thickness while they slide.
TEST(Sliding, KeepsTheHeights) {
  LayerRun run(leaning_channel(0.5), {1.0, 0.08, 1.05});
  run.grow(9);
  for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!run.mesh.alive(v) || run.mesh.data(v).layer == 0) continue;
    const Vec3& p = run.mesh.position(v);
    if (p.x() < 4.0 || p.x() > 8.0) continue;
    const double up = p.y() - run.mesh.position(run.mesh.data(v).parent).y();
    const double asked = 0.08 * std::pow(1.05, run.mesh.data(v).layer - 1);
    EXPECT_NEAR(std::abs(up), asked, 0.02 * asked);
  }
}

// Around a bend geodesics cross on one side and part on the other; no layer may cut through it.
TEST(Sliding, LayersFollowTheBendOfAPipe) {
  const gp_Torus torus(gp_Ax3(), 4.0, 1.0);
  const TopoDS_Face bend = BRepBuilderAPI_MakeFace(torus, 0.0, M_PI, 0.0, 2.0 * M_PI).Face();
  LayerRun run(bend, {1.0, 0.1, 1.2});
  run.walls.max_height = 1.0;
  run.grow();
  EXPECT_EQ(find_connectivity_fault(run.mesh), "");
  EXPECT_EQ(find_inverted_element(run.mesh), "");
  int edges = 0;
  for (std::size_t i = 0; i < run.mesh.halfedge_capacity(); ++i) {
    const HalfedgeH h(i);
    if (!run.mesh.alive(h) || run.mesh.is_border(h)) continue;
    if (run.mesh.data(run.mesh.face(h)).layer == 0) continue;
    const VertexData& from = run.mesh.data(run.mesh.from(h));
    const VertexData& to = run.mesh.data(run.mesh.to(h));
    EXPECT_GT(from.normal.dot(to.normal), 0.5) << from.point.xyz.transpose();
    ++edges;
  }
  EXPECT_GT(edges, 400);
}

}  // namespace
}  // namespace advlayers::test
