#include "mesher/doubled_edges.h"

#include <algorithm>
#include <utility>

namespace advlayers {
namespace {

using NodePair = std::pair<NodeId, NodeId>;

struct Chord {
  NodePair ends;
  std::size_t job;
  HalfedgeH edge;
  bool operator<(const Chord& o) const {
    if (ends != o.ends) return ends < o.ends;
    return job != o.job ? job < o.job : edge < o.edge;
  }
};

// Every edge between two boundary nodes: of borders, and inside patches.
void collect(const RunContext& context, const PatchJobs& jobs, std::vector<NodePair>& borders,
             std::vector<Chord>& chords) {
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (!jobs[k]->meshed()) continue;
    const SurfaceMesh& mesh = jobs[k]->mesh();
    for (std::size_t i = 0; i < mesh.halfedge_capacity(); i += 2) {
      const HalfedgeH h(i);
      if (!mesh.alive(h)) continue;
      context.check();
      const NodeId a = mesh.data(mesh.from(h)).node, b = mesh.data(mesh.to(h)).node;
      if (!a.valid() || !b.valid()) continue;
      const NodePair ends = std::minmax(a, b);
      if (mesh.is_border(h) || mesh.is_border(SurfaceMesh::twin(h))) {
        borders.push_back(ends);
      } else {
        chords.push_back({ends, k, h});
      }
    }
  }
  std::sort(borders.begin(), borders.end());
  std::sort(chords.begin(), chords.end());
}

}  // namespace

void part_doubled_edges(const RunContext& context, const PatchJobs& jobs,
                        const Discretization& boundary) {
  std::vector<NodePair> borders;
  std::vector<Chord> chords;
  collect(context, jobs, borders, chords);
  std::vector<std::vector<HalfedgeH>> doubled(jobs.size());
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const bool again = i > 0 && chords[i - 1].ends == chords[i].ends;
    if (again || std::binary_search(borders.begin(), borders.end(), chords[i].ends)) {
      doubled[chords[i].job].push_back(chords[i].edge);
    }
  }
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (!doubled[k].empty()) jobs[k]->split_edges(context, doubled[k], boundary);
  }
}

}  // namespace advlayers
