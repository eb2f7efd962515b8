// The invariants of the front system, asked after every step of every layer.
#include <gtest/gtest.h>

#include <functional>

#include "layers/layer_run.h"
#include "layers/layer_shapes.h"

namespace advlayers::test {
namespace {

struct Case {
  const char* name;
  std::function<TopoDS_Shape()> shape;
  LayerSizes sizes;
  bool flat = true;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Case kCases[] = {
    {"Square", [] { return rectangle(10, 10); }, {}},
    {"Rectangle", [] { return rectangle(20, 4); }, {1.0, 0.05, 1.1}},
    {"L", l_shape, {}},
    {"Disc", [] { return disc(5); }, {}},
    {"PlateWithHoles", plate_with_holes, {}},
    {"PlateWithHolesThinLayers", plate_with_holes, {0.8, 0.004, 1.3}},
    {"SharpPolygon", sharp_polygon, {1.0, 0.08, 1.08}},
    {"NotchedPlate", notched_plate, {}},
    {"Cylinder", [] { return cylinder_side(3, 8); }, {}, false},
    {"Cone", cone_side, {}, false},
    {"HalfSphere", [] { return half_sphere(5); }, {}, false},
    {"Saddle", saddle, {}, false},
    {"ExtrudedSpline", extruded_spline, {0.8, 0.02, 1.2}, false},
};

class EveryStep : public ::testing::TestWithParam<Case> {};

// What is wrong with the mesh, against the triangulation it grew from; empty: nothing.
class Invariants {
 public:
  Invariants(const SurfaceMesh& mesh, double tolerance)
      : euler_(euler_number(mesh)),
        area_(area_of_elements(mesh)),
        tolerance_(tolerance),
        border_(border_of(mesh)) {}

  std::string fault(const SurfaceMesh& mesh) const {
    if (std::string text = find_connectivity_fault(mesh); !text.empty()) return text;
    if (std::string text = find_inverted_element(mesh); !text.empty()) return text;
    if (euler_number(mesh) != euler_) return "another Euler number";
    if (border_of(mesh) != border_) return "another border";
    const double area = area_of_elements(mesh);
    if (std::abs(area - area_) > tolerance_ * area_) {
      return "area " + std::to_string(area) + " after " + std::to_string(area_);
    }
    return "";
  }

 private:
  int euler_;
  double area_, tolerance_;
  std::vector<BorderEdge> border_;
};

// A chord that turns by 20 degrees cuts off 2 % of a disc's area; flat faces keep theirs.
double area_tolerance(bool flat) { return flat ? 1e-12 : 0.0205; }

TEST_P(EveryStep, LeavesAValidMeshOfThePatch) {
  LayerRun run(GetParam().shape(), GetParam().sizes);
  const Invariants invariants(run.mesh, area_tolerance(GetParam().flat));
  ASSERT_EQ(invariants.fault(run.mesh), "");
  std::string first_fault;
  int steps = 0;
  run.layers().set_step_hook([&](Step step, const SurfaceMesh& mesh) {
    ++steps;
    if (!first_fault.empty()) return;
    const std::string fault = invariants.fault(mesh);
    if (fault.empty()) return;
    first_fault =
        "layer " + std::to_string(run.reports.size() + 1) + ", " + step_name(step) + ": " + fault;
  });
  run.grow();
  EXPECT_EQ(first_fault, "");
  EXPECT_EQ(steps, 9 * static_cast<int>(run.reports.size()));
  EXPECT_GE(run.reports.size(), 3u);
  const ElementCount before = elements_of(run.mesh);
  EXPECT_FALSE(run.layers().advance().has_value());  // and changes nothing
  EXPECT_TRUE(elements_of(run.mesh) == before);
}

TEST_P(EveryStep, LeavesVerticesOnTheSurface) {
  LayerRun run(GetParam().shape(), GetParam().sizes);
  run.grow();
  const double tolerance = 1e-9 * run.model.diagonal();
  for (std::size_t i = 0; i < run.mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!run.mesh.alive(v) || run.mesh.data(v).layer == 0) continue;
    const SurfacePoint& p = run.mesh.data(v).point;
    ASSERT_LE((run.evaluator.frame(p.face, p.u, p.v).xyz - p.xyz).norm(), tolerance);
    EXPECT_LT((run.surface.normal(p) - run.mesh.data(v).normal).norm(), 1e-9);
  }
}

// Parents are set when a vertex is extruded; every quad of a layer holds a parent-kid edge.
TEST_P(EveryStep, KnowsParentsAndLayers) {
  LayerRun run(GetParam().shape(), GetParam().sizes);
  run.grow();
  const SurfaceMesh& mesh = run.mesh;
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    const VertexH v(i);
    if (!mesh.alive(v) || mesh.data(v).layer == 0) continue;
    const VertexH parent = mesh.data(v).parent;
    ASSERT_TRUE(parent.valid() && mesh.alive(parent));
    ASSERT_EQ(mesh.data(parent).layer + 1, mesh.data(v).layer);
    EXPECT_EQ(mesh.data(parent).layer == 0, mesh.data(parent).support != Support::kPatch);
  }
  for (std::size_t i = 0; i < mesh.face_capacity(); ++i) {
    const FaceH f(i);
    if (!mesh.alive(f) || mesh.data(f).layer == 0 || mesh.degree(f) != 4) continue;
    bool joined = false;
    for (const HalfedgeH h : mesh.sides(f)) {
      const VertexH a = mesh.from(h), b = mesh.to(h);
      joined = joined || mesh.data(a).parent == b || mesh.data(b).parent == a;
    }
    EXPECT_TRUE(joined) << "quad " << i << " of layer " << mesh.data(f).layer;
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, EveryStep, ::testing::ValuesIn(kCases),
                         [](const auto& instance) { return std::string(instance.param.name); });

// One wall among edges without layers: open chains, whose ends meet what does not move.
TEST_P(EveryStep, LeavesAValidMeshWithOneWall) {
  LayerRun run(GetParam().shape(), GetParam().sizes);
  const EdgeId wall =
      std::min_element(run.walls.edges.begin(), run.walls.edges.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; })
          ->first;
  for (auto& [edge, plan] : run.walls.edges) {
    if (edge != wall) plan.condition = EdgeCondition::kOff;
  }
  const Invariants invariants(run.mesh, area_tolerance(GetParam().flat));
  std::string first_fault;
  run.layers().set_step_hook([&](Step step, const SurfaceMesh& mesh) {
    if (first_fault.empty() && !invariants.fault(mesh).empty()) {
      first_fault = std::string(step_name(step)) + ": " + invariants.fault(mesh);
    }
  });
  run.grow();
  EXPECT_EQ(first_fault, "");
  EXPECT_GE(run.reports.size(), 3u);
  EXPECT_GT(elements_of(run.mesh).quads, 0);
}

// A user may stop after any layer: each stop gives what a longer run had there, and a valid mesh.
TEST(StoppedAtALayer, IsTheLongRunSoFar) {
  LayerRun whole(plate_with_holes());
  std::vector<ElementCount> after;
  while (whole.advance()) after.push_back(elements_of(whole.mesh));
  ASSERT_GE(after.size(), 8u);
  for (std::size_t k = 1; k <= after.size(); ++k) {
    LayerRun run(plate_with_holes());
    const Invariants invariants(run.mesh, area_tolerance(true));
    run.grow(static_cast<int>(k));
    EXPECT_EQ(invariants.fault(run.mesh), "") << "stopped after layer " << k;
    EXPECT_TRUE(elements_of(run.mesh) == after[k - 1]) << "stopped after layer " << k;
  }
}

}  // namespace
}  // namespace advlayers::test
