// First heights, growth, fans and quads, measured on the mesh the layers leave.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/angles.h"
#include "base/directions.h"
#include "layers/layer_run.h"
#include "layers/layer_shapes.h"
#include "mesh/triangle_measures.h"

namespace advlayers::test {
namespace {

// Border vertices in a row around one loop, the patch on the left.
std::vector<std::vector<VertexH>> loops_of(const SurfaceMesh& mesh) {
  std::vector<std::vector<VertexH>> loops;
  std::vector<std::uint8_t> seen(mesh.halfedge_capacity(), 0);
  for (std::size_t i = 0; i < mesh.halfedge_capacity(); ++i) {
    HalfedgeH h(i);
    if (!mesh.alive(h) || !mesh.is_border(h) || seen[i] != 0) continue;
    loops.emplace_back();
    for (; seen[h.index()] == 0; h = mesh.prev(h)) {
      seen[h.index()] = 1;
      loops.back().push_back(mesh.to(h));
    }
  }
  return loops;
}

// Wall vertices farther than `away` edges from any turn of 20 degrees or more.
std::vector<VertexH> regular_wall_vertices(const SurfaceMesh& mesh, int away) {
  std::vector<VertexH> regular;
  for (const std::vector<VertexH>& loop : loops_of(mesh)) {
    const int n = static_cast<int>(loop.size());
    const auto at = [&](int k) { return loop[static_cast<std::size_t>((k + n) % n)]; };
    const auto turns = [&](int k) {
      const Vec3& p = mesh.position(at(k));
      const double angle = turn_angle(mesh.position(at(k + 1)) - p, mesh.position(at(k - 1)) - p,
                                      mesh.data(at(k)).normal);
      return std::abs(M_PI - angle) >= 20.5 * kDegree;
    };
    for (int k = 0; k < n; ++k) {
      bool straight = true;
      for (int d = -away; d <= away; ++d) straight = straight && !turns(k + d);
      if (straight) regular.push_back(at(k));
    }
  }
  return regular;
}

struct Case {
  const char* name;
  std::function<TopoDS_Shape()> shape;
  double radius = INFINITY;  // of the great circles that heights are measured along
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Heights : public ::testing::TestWithParam<Case> {
 protected:
  double arc(const Vec3& a, const Vec3& b) const {
    const double chord = (a - b).norm(), radius = GetParam().radius;
    return std::isinf(radius) ? chord : 2 * radius * std::asin(0.5 * chord / radius);
  }
};

TEST_P(Heights, FirstHeightAndGrowthAreAsAsked) {
  const LayerSizes sizes{0.5, 0.05, 1.15};
  LayerRun run(GetParam().shape(), sizes);
  run.grow(6);
  ASSERT_EQ(run.reports.size(), 6u);
  const auto kids = kids_by_parent(run.mesh);
  const std::vector<VertexH> regular = regular_wall_vertices(run.mesh, 6);
  ASSERT_GE(regular.size(), 15u);
  int growths = 0;
  for (const VertexH wall : regular) {
    ASSERT_EQ(kids[wall.index()].size(), 1u);
    VertexH parent = wall, kid = kids[wall.index()][0];
    double height = arc(run.mesh.position(parent), run.mesh.position(kid));
    EXPECT_NEAR(height, sizes.first_height, 0.02 * sizes.first_height);
    while (kids[kid.index()].size() == 1) {
      parent = kid;
      kid = kids[kid.index()][0];
      const double next = arc(run.mesh.position(parent), run.mesh.position(kid));
      EXPECT_NEAR(next / height, sizes.growth, 0.03 * sizes.growth);
      height = next;
      ++growths;
    }
  }
  EXPECT_EQ(growths, 5 * static_cast<int>(regular.size()));
}

// Kids of regular vertices stand on the wall at a right angle.
TEST_P(Heights, ColumnsStandOnTheWall) {
  LayerRun run(GetParam().shape(), {0.5, 0.05, 1.15});
  run.grow(1);
  const auto kids = kids_by_parent(run.mesh);
  double sum = 0.0;
  int count = 0;
  for (const VertexH wall : regular_wall_vertices(run.mesh, 2)) {
    ASSERT_EQ(kids[wall.index()].size(), 1u);
    const HalfedgeH border = run.mesh.outgoing(wall);
    const Vec3 along = (run.mesh.position(run.mesh.to(border)) -
                        run.mesh.position(run.mesh.from(run.mesh.prev(border))))
                           .normalized();
    const Vec3 up =
        (run.mesh.position(kids[wall.index()][0]) - run.mesh.position(wall)).normalized();
    sum += std::asin(std::abs(along.dot(up)));
    ++count;
  }
  ASSERT_GT(count, 0);
  EXPECT_LE(sum / count, 1.0 * kDegree);
}

const Case kCases[] = {
    {"Plane", [] { return rectangle(12, 8); }},
    {"Cylinder", [] { return cylinder_side(3, 8); }},
    {"Cone", cone_side},
    {"SphereCap", [] { return half_sphere(5); }, 5.0},
};
INSTANTIATE_TEST_SUITE_P(Surfaces, Heights, ::testing::ValuesIn(kCases),
                         [](const auto& instance) { return std::string(instance.param.name); });

VertexH vertex_at(const SurfaceMesh& mesh, const Vec3& xyz) {
  for (std::size_t i = 0; i < mesh.vertex_capacity(); ++i) {
    if (mesh.alive(VertexH(i)) && (mesh.position(VertexH(i)) - xyz).norm() < 1e-9) {
      return VertexH(i);
    }
  }
  return {};
}

struct Fan {
  const char* name;
  std::function<TopoDS_Shape()> shape;
  int quads;
};
void PrintTo(const Fan& fan, std::ostream* out) { *out << fan.name; }

class Fans : public ::testing::TestWithParam<Fan> {};

// The convex corner of both shapes lies at (5, 5).
TEST_P(Fans, SurroundTheCornerWithQuads) {
  LayerRun run(GetParam().shape());
  run.grow(1);
  const VertexH corner = vertex_at(run.mesh, Vec3(5, 5, 0));
  ASSERT_TRUE(corner.valid());
  int quads = 0;
  for (const HalfedgeH h : run.mesh.around(corner)) {
    if (!run.mesh.is_border(h)) quads += !run.mesh.is_triangle(h);
  }
  EXPECT_EQ(quads, GetParam().quads);
  EXPECT_EQ(run.events(Event::kFan), 1);
}

TEST_P(Fans, KeepTheirEdgesForTwoLayersMore) {
  LayerRun run(GetParam().shape());
  run.grow(3);
  const auto kids = kids_by_parent(run.mesh);
  std::vector<VertexH> fan = kids[vertex_at(run.mesh, Vec3(5, 5, 0)).index()];
  const std::size_t spokes = 2 * static_cast<std::size_t>(GetParam().quads - 2) + 1;
  EXPECT_EQ(fan.size(), spokes);
  for (int layer = 2; layer <= 3; ++layer) {
    std::vector<VertexH> next;
    for (const VertexH v : fan) {
      EXPECT_EQ(kids[v.index()].size(), 1u);
      next.insert(next.end(), kids[v.index()].begin(), kids[v.index()].end());
    }
    fan = next;
  }
  EXPECT_EQ(fan.size(), spokes);
}

const Fan kFans[] = {{"Corner270", l_shape, 3}, {"Notch340", notched_plate, 4}};
INSTANTIATE_TEST_SUITE_P(Corners, Fans, ::testing::ValuesIn(kFans),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace advlayers::test
