// A model meshed to the end, and what every mesh of a closed or open shell must be.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <utility>
#include <vector>

#include "coarse_settings.h"
#include "mesher/mesher.h"

namespace advlayers::test {

// Layers from a tenth of the size on.
inline Settings settings_of(double size) {
  Settings settings = test::coarse_settings();
  settings.size = size;
  settings.first_height = size / 10;
  return settings;
}

inline MeshResult mesh_of(const Model& model, const Settings& settings) {
  RunContext context;
  Mesher mesher(context, model, settings);
  while (mesher.next()) {
  }
  return mesher.result();
}

// How many elements use each mesh edge, by its ends.
inline std::map<std::pair<int, int>, int> uses_of_edges(const MeshResult& mesh) {
  std::map<std::pair<int, int>, int> uses;
  const auto add = [&uses](const auto& element) {
    for (std::size_t k = 0; k < element.size(); ++k) {
      ++uses[std::minmax(element[k], element[(k + 1) % element.size()])];
    }
  };
  for (const auto& quad : mesh.quads) add(quad);
  for (const auto& triangle : mesh.triangles) add(triangle);
  return uses;
}

inline void expect_watertight(const MeshResult& mesh) {
  for (const auto& [edge, count] : uses_of_edges(mesh)) {
    EXPECT_EQ(count, 2) << edge.first << " - " << edge.second;
  }
}

}  // namespace advlayers::test
