#include "base/point_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace advlayers {

PointTree::PointTree(const RunContext& context, std::vector<Vec3> points)
    : points_(std::move(points)), order_(points_.size()), axis_(points_.size(), 0) {
  std::iota(order_.begin(), order_.end(), 0);
  divide(context, 0, order_.size());
}

void PointTree::divide(const RunContext& context, std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  Eigen::AlignedBox3d box;
  for (std::size_t i = begin; i < end; ++i) {
    box.extend(points_[static_cast<std::size_t>(order_[i])]);
  }
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](int a, int b) {
    context.check();
    const double pa = points_[static_cast<std::size_t>(a)][axis];
    const double pb = points_[static_cast<std::size_t>(b)][axis];
    return pa != pb ? pa < pb : a < b;
  });
  axis_[middle] = static_cast<signed char>(axis);
  divide(context, begin, middle);
  divide(context, middle + 1, end);
}

int PointTree::nearest(const Vec3& p) const {
  int best = -1;
  double best2 = std::numeric_limits<double>::infinity();
  search(0, order_.size(), p, best, best2);
  return best;
}

void PointTree::search(std::size_t begin, std::size_t end, const Vec3& p, int& best,
                       double& best2) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Vec3& here = points_[static_cast<std::size_t>(order_[middle])];
  const double distance2 = (p - here).squaredNorm();
  if (distance2 < best2) {
    best2 = distance2;
    best = order_[middle];
  }
  const double beyond = p[axis_[middle]] - here[axis_[middle]];
  if (beyond < 0) {
    search(begin, middle, p, best, best2);
    if (beyond * beyond < best2) search(middle + 1, end, p, best, best2);
  } else {
    search(middle + 1, end, p, best, best2);
    if (beyond * beyond < best2) search(begin, middle, p, best, best2);
  }
}

}  // namespace advlayers
