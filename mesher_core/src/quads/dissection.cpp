#include "quads/dissection.h"

#include <algorithm>

#include "measure/element_measures.h"

namespace advlayers {
namespace {

class Dissector {
 public:
  Dissector(const SurfaceMesh& mesh, const std::vector<VertexH>& loop, double longest, double least)
      : mesh_(mesh), loop_(loop), longest_(longest), least_(least) {}

  Dissection run() {
    const std::size_t n = loop_.size();
    for (std::size_t i = 0; i + 1 < n; ++i) best_[i][i + 1].worst = 1.0;
    for (std::size_t span = 3; span < n; span += 2) {
      for (std::size_t i = 0; i + span < n; ++i) solve(i, i + span);
    }
    Dissection result;
    result.worst = best_[0][n - 1].worst;
    if (result.worst > 0.0) collect(0, n - 1, result);
    return result;
  }

 private:
  // The part of the polygon from corner i to corner j, and the quad on their chord.
  struct Part {
    double worst = -1.0;
    std::size_t k = 0, l = 0;
  };

  void solve(std::size_t i, std::size_t j) {
    const bool whole = i == 0 && j + 1 == loop_.size();
    if (!whole && (at(i) - at(j)).norm() > longest_) return;
    Part& part = best_[i][j];
    for (std::size_t k = i + 1; k < j; k += 2) {
      if (best_[i][k].worst <= part.worst) continue;
      for (std::size_t l = k + 1; l < j; l += 2) {
        const double sides = std::min(best_[k][l].worst, best_[l][j].worst);
        if (sides <= part.worst) continue;
        const double quad = quad_quality(mesh_, loop_[i], loop_[k], loop_[l], loop_[j]);
        const double worst = std::min({quad, sides, best_[i][k].worst});
        if (quad >= least_ && worst > part.worst) part = {worst, k, l};
      }
    }
  }

  void collect(std::size_t i, std::size_t j, Dissection& result) const {
    if (j == i + 1) return;
    const auto& [worst, k, l] = best_[i][j];
    result.quads.push_back({loop_[i], loop_[k], loop_[l], loop_[j]});
    collect(i, k, result);
    collect(k, l, result);
    collect(l, j, result);
  }

  const Vec3& at(std::size_t i) const { return mesh_.position(loop_[i]); }

  const SurfaceMesh& mesh_;
  const std::vector<VertexH>& loop_;
  double longest_, least_;
  std::array<std::array<Part, kMostCorners>, kMostCorners> best_;
};

}  // namespace

Dissection dissect(const SurfaceMesh& mesh, const std::vector<VertexH>& loop, double longest,
                   double least) {
  return Dissector(mesh, loop, longest, least).run();
}

}  // namespace advlayers
