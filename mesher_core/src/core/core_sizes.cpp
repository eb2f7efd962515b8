#include "core/core_sizes.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace advlayers {
namespace {

// The border's lengths may differ from the size by this factor, and rows begin with them; what
// is shorter still grows into the size.
constexpr double kMostFit = 1.25;
// A front's last height may be less than its edges are long by this factor, for rows to go on so.
constexpr double kFlattest = 1.6;
// Rows go on from longer edges than that as if they were so long [sizes].
constexpr double kMostOver = 2.0;
const double kMost = std::log(2.5);  // that lengths may differ from the graded size by
constexpr double kSmallest = 1e-3;   // of the size, however short an edge is
constexpr double kGoOn = 1.1;        // first row of the core over the last layer
constexpr double kScreening = 1.0;   // how much lengths are drawn to the size, over the whole room

struct Reached {
  double size;
  VertexH vertex;
  bool operator>(const Reached& o) const {
    return size != o.size ? size > o.size : o.vertex < vertex;
  }
};

class SizeSolver {
 public:
  SizeSolver(const SurfaceMesh& mesh, const CoreRoom& room,
             const std::vector<CrossDirection>& crosses, TargetSize& target)
      : mesh_(mesh), room_(room), crosses_(crosses), target_(target) {}

  std::vector<CrossSizes> run(bool two_lengths) {
    edges_ = room_.edges(mesh_);
    measure_border();
    grade();
    fits_.assign(2 * room_.vertices.size(), 0.0);
    if (two_lengths) fit();
    std::vector<CrossSizes> sizes(room_.vertices.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      for (std::size_t arm = 0; arm < 2; ++arm) {
        sizes[k][arm] = graded_[k] * std::exp(std::clamp(fits_[2 * k + arm], -kMost, kMost));
      }
    }
    return sizes;
  }

 private:
  Vec3 across(std::size_t k) const {
    return mesh_.data(room_.vertices[k]).normal.cross(crosses_[k].along);
  }
  std::size_t arm(std::size_t k, const Vec3& direction) const {
    return std::abs(direction.dot(crosses_[k].along)) < std::abs(direction.dot(across(k))) ? 1 : 0;
  }

  // Means of the border's edges along each arm, and of the last layer's heights.
  void measure_border() {
    const std::size_t count = room_.vertices.size();
    lengths_.assign(2 * count, 0.0);
    counts_.assign(2 * count, 0.0);
    std::vector<double> heights(2 * count, 0.0), height_counts(2 * count, 0.0);
    for (const HalfedgeH h : room_.border) {
      const Vec3 edge = mesh_.position(mesh_.to(h)) - mesh_.position(mesh_.from(h));
      const double height = height_beyond(h);
      for (const VertexH v : {mesh_.from(h), mesh_.to(h)}) {
        const std::size_t k = room_.number(v);
        const std::size_t i = 2 * k + arm(k, edge);
        lengths_[i] += edge.norm();
        counts_[i] += 1.0;
        if (!(height > 0.0)) continue;
        heights[i ^ 1] += kGoOn * std::clamp(height, edge.norm() / kFlattest, edge.norm());
        height_counts[i ^ 1] += 1.0;
      }
    }
    for (std::size_t i = 0; i < lengths_.size(); ++i) {
      if (counts_[i] == 0.0) {
        lengths_[i] = heights[i];
        counts_[i] = height_counts[i];
      }
      if (counts_[i] > 0.0) lengths_[i] /= counts_[i];
    }
  }

  // Of the layer's cell on the other side of a border edge; 0 where there is none.
  double height_beyond(HalfedgeH h) const {
    const HalfedgeH t = SurfaceMesh::twin(h);
    if (mesh_.is_border(t) || mesh_.is_triangle(t) || is_core(mesh_, mesh_.face(t))) return 0.0;
    if (is_extrusion(mesh_, h)) return 0.0;
    const auto length = [&](HalfedgeH e) {
      return (mesh_.position(mesh_.to(e)) - mesh_.position(mesh_.from(e))).norm();
    };
    return 0.5 * (length(mesh_.next(t)) + length(mesh_.prev(t)));
  }

  void grade() {
    const std::size_t count = room_.vertices.size();
    graded_.resize(count);
    std::vector<std::size_t> starts(count + 1, 0);
    for (const RoomEdge& edge : edges_) {
      ++starts[room_.number(edge.from)];
      ++starts[room_.number(edge.to)];
    }
    std::size_t sum = 0;
    for (std::size_t& start : starts) sum += std::exchange(start, sum);
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1), beside(sum);
    for (const RoomEdge& edge : edges_) {
      const std::size_t a = room_.number(edge.from), b = room_.number(edge.to);
      beside[next[a]++] = b;
      beside[next[b]++] = a;
    }
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
    for (std::size_t k = 0; k < count; ++k) {
      graded_[k] = target_.at(mesh_.data(room_.vertices[k]).point);
      const double least = kSmallest * graded_[k];
      for (const std::size_t i : {2 * k, 2 * k + 1}) {
        if (counts_[i] == 0.0) continue;
        lengths_[i] = std::max(lengths_[i], least);
        graded_[k] = std::min(graded_[k], kMostFit * lengths_[i]);
      }
      queue.push({graded_[k], VertexH(k)});
    }
    while (!queue.empty()) {
      const Reached reached = queue.top();
      queue.pop();
      const std::size_t k = reached.vertex.index();
      if (reached.size > graded_[k]) continue;
      for (std::size_t i = starts[k]; i < starts[k + 1]; ++i) {
        const std::size_t j = beside[i];
        const double way =
            (mesh_.position(room_.vertices[j]) - mesh_.position(room_.vertices[k])).norm();
        const double size = reached.size + target_.gradation() * way;
        if (size >= graded_[j]) continue;
        graded_[j] = size;
        queue.push({size, VertexH(j)});
      }
    }
  }

  // Logarithms of the lengths over the graded size: as smooth as can be between the border's.
  void fit() {
    const std::size_t count = 2 * room_.vertices.size();
    std::vector<int> unknown(count, -1);
    int unknowns = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (counts_[i] > 0.0) {
        fits_[i] = std::log(std::min(kMostOver, lengths_[i] / graded_[i / 2]));
      } else {
        unknown[i] = unknowns++;
      }
    }
    if (unknowns == 0) return;
    double count_in_room = 0.0;
    // In elements: where these are small, borders far away have no say.
    const auto elements = [&](const RoomEdge& edge) {
      return edge.area / (graded_[room_.number(edge.from)] * graded_[room_.number(edge.to)]);
    };
    for (const RoomEdge& edge : edges_) count_in_room += elements(edge) / 3.0;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    for (const RoomEdge& edge : edges_) {
      const std::size_t a = room_.number(edge.from), b = room_.number(edge.to);
      const std::size_t swap = arm(b, crosses_[a].along);
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t i = 2 * a + k, j = 2 * b + (k ^ swap);
        const int p = unknown[i], q = unknown[j];
        const double mass = kScreening / count_in_room * elements(edge) / 6.0;
        if (p >= 0) entries.emplace_back(p, p, edge.weight + mass);
        if (q >= 0) entries.emplace_back(q, q, edge.weight + mass);
        if (p >= 0 && q >= 0) {
          entries.emplace_back(p, q, -edge.weight);
          entries.emplace_back(q, p, -edge.weight);
        } else if (p >= 0) {
          right[p] += edge.weight * fits_[j];
        } else if (q >= 0) {
          right[q] += edge.weight * fits_[i];
        }
      }
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::VectorXd found = solver.solve(right);
    for (std::size_t i = 0; i < count; ++i) {
      if (unknown[i] >= 0) fits_[i] = found[unknown[i]];
    }
  }

  const SurfaceMesh& mesh_;
  const CoreRoom& room_;
  const std::vector<CrossDirection>& crosses_;
  TargetSize& target_;
  std::vector<RoomEdge> edges_;
  // By arm: two for each vertex.
  std::vector<double> lengths_, counts_, fits_;
  std::vector<double> graded_;  // by vertex
};

}  // namespace

std::vector<CrossSizes> find_core_sizes(const SurfaceMesh& mesh, const CoreRoom& room,
                                        const std::vector<CrossDirection>& crosses, int arms,
                                        TargetSize& target) {
  return SizeSolver(mesh, room, crosses, target).run(arms == 4);
}

}  // namespace advlayers
