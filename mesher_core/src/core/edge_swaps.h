// Swaps of the core's edges that raise the least angle, about what has changed.
#pragma once

#include <vector>

#include "layers/reconnect.h"
#include "mesh/surface_mesh.h"

namespace advlayers {

class EdgeSwaps {
 public:
  explicit EdgeSwaps(SurfaceMesh& mesh) : mesh_(mesh) {}

  // Edges about the vertex, and those across from it.
  void enlist_about(VertexH v);
  void enlist(HalfedgeH h) { waiting_.push_back(h); }
  void run() {
    run([](HalfedgeH) {});
  }
  // Calls visit(h) for each edge that was swapped.
  template <class Visit>
  void run(const Visit& visit) {
    // Each swap raises the least angle of its pair, so this ends; the bound only guards round-off.
    std::size_t budget = kMostTries * (waiting_.size() + kMostTries);
    while (!waiting_.empty() && budget-- > 0) {
      const HalfedgeH h = waiting_.back();
      waiting_.pop_back();
      if (swap(h)) visit(h);
    }
    waiting_.clear();
  }

 private:
  static constexpr std::size_t kMostTries = 40;  // for each edge that waits, on the average

  bool swap(HalfedgeH h);

  SurfaceMesh& mesh_;
  ReconnectLimits limits_;
  std::vector<HalfedgeH> waiting_;
};

}  // namespace advlayers
