#include "geometry/stl_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "geometry/facet_shape.h"
#include "geometry/occt_shape.h"
#include "geometry/sew_shape.h"

namespace advlayers {
namespace {

const std::vector<std::array<Vec3, 3>>& tetrahedron() {
  static const Vec3 o(0, 0, 0), x(3, 0, 0), y(0, 2, 0), z(0, 0, 1);
  static const std::vector<std::array<Vec3, 3>> triangles{
      {o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
  return triangles;
}

std::string as_text() {
  std::ostringstream text;
  text << "solid four sides\n";
  for (const auto& triangle : tetrahedron()) {
    text << " facet normal 0 0 0\n  outer loop\n";
    for (const Vec3& p : triangle) text << "   vertex " << p.transpose() << "\n";
    text << "  endloop\n endfacet\n";
  }
  text << "endsolid four sides\n";
  return text.str();
}

std::string as_bytes() {
  std::string bytes(80, 's');
  const auto count = static_cast<std::uint32_t>(tetrahedron().size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle : tetrahedron()) {
    std::array<float, 12> numbers{};
    for (std::size_t i = 0; i < 9; ++i) {
      numbers[3 + i] = static_cast<float>(triangle[i / 3][static_cast<int>(i % 3)]);
    }
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(StlText, BothKindsGiveTheSameTriangles) {
  EXPECT_EQ(stl_triangles(as_text()), tetrahedron());
  EXPECT_EQ(stl_triangles(as_bytes()), tetrahedron());
  EXPECT_EQ(stl_triangles(as_text() + as_text()).size(), 8u);
}

TEST(StlText, EveryCutIsSeen) {
  const std::string text = as_text(), bytes = as_bytes();
  // What follows "endsolid" is a name.
  for (std::size_t n = 0; n + 12 < text.size(); ++n) {
    EXPECT_THROW(stl_triangles(text.substr(0, n)), InvalidInput) << n;
  }
  for (std::size_t n = 0; n < bytes.size(); ++n) {
    EXPECT_THROW(stl_triangles(bytes.substr(0, n)), InvalidInput) << n;
  }
  EXPECT_THROW(stl_triangles(bytes + "x"), InvalidInput);
}

TEST(StlText, NumbersThatAreNoneAreSeen) {
  std::string text = as_text(), bytes = as_bytes();
  text.replace(text.find("vertex 0"), 8, "vertex n");
  EXPECT_THROW(stl_triangles(text), InvalidInput);
  const float nowhere = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&bytes[84 + 12], &nowhere, sizeof nowhere);
  EXPECT_THROW(stl_triangles(bytes), InvalidInput);
}

Model model_of(const std::vector<std::array<Vec3, 3>>& triangles) {
  auto shape = std::make_unique<Model::Shape>();
  shape->root = shape_of_triangles(triangles);
  return model_of_shape(RunContext(), std::move(shape), 0.0);
}

TEST(FacetShape, TrianglesShareTheirEdges) {
  const Model model = model_of(tetrahedron());
  EXPECT_EQ(model.faces().size(), 4u);
  EXPECT_EQ(model.edges().size(), 6u);
  EXPECT_EQ(model.vertices().size(), 4u);
  EXPECT_TRUE(model.closed() && model.triangular());
}

TEST(FacetShape, NearbyCornersAreOneAndFlatTrianglesNone) {
  std::vector<std::array<Vec3, 3>> triangles = tetrahedron();
  triangles[1][0] += Vec3(1e-7, -1e-7, 1e-7);
  triangles.push_back(triangles[2]);
  triangles.push_back({Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 0, 0)});
  const Model model = model_of(triangles);
  EXPECT_EQ(model.faces().size(), 4u);
  EXPECT_TRUE(model.closed());
  EXPECT_TRUE(shape_of_triangles({}).IsNull());
}

}  // namespace
}  // namespace advlayers
