// The nearest of many points: a balanced k-d tree without pointers.
#pragma once

#include <vector>

#include "base/run_context.h"
#include "base/types.h"

namespace advlayers {

class PointTree {
 public:
  PointTree() = default;
  // Throws Cancelled.
  PointTree(const RunContext& context, std::vector<Vec3> points);

  bool empty() const { return points_.empty(); }
  // Index of the point nearest to p, of equally near ones the first in the tree; -1: there is none.
  int nearest(const Vec3& p) const;

 private:
  // The middle of a range divides it along axis_[middle]; what lies before it is not beyond it.
  void divide(const RunContext& context, std::size_t begin, std::size_t end);
  void search(std::size_t begin, std::size_t end, const Vec3& p, int& best, double& best2) const;

  std::vector<Vec3> points_;
  std::vector<int> order_;
  std::vector<signed char> axis_;
};

}  // namespace advlayers
