#include "mesher/halving_rounds.h"

#include <algorithm>
#include <set>
#include <vector>

#include "boundary/halve_edges.h"
#include "boundary/periodic_cuts.h"

namespace advlayers {
namespace {

// Times that the edges of a face may be halved where they are too coarse for it.
constexpr std::size_t kMostHalvings = 6;
// And for the sake of a face that is meshed all the same, but with triangles turned over.
constexpr std::size_t kMostForBetter = 2;

using AskedEdges = std::vector<std::vector<EdgeId>>;  // by patch: edges it finds too coarse

class HalvingRounds {
 public:
  HalvingRounds(const RunContext& context, const Model& model, JobList& list,
                const std::vector<EdgePair>& periodic, Discretization& boundary)
      : context_(context),
        evaluator_(model),
        list_(list),
        periodic_(periodic),
        boundary_(boundary) {}

  void run() {
    for (const auto& job : list_.jobs()) waiting_.push_back(job->meshed() ? 0 : 1);
    const Discretization before = boundary_;
    ask();
    if (rounds_.empty()) return;
    boundary_ = before;
    std::set<EdgeId> halved;
    std::vector<char> cured(waiting_);
    for (char& c : cured) c = c ? 0 : 1;
    for (const AskedEdges& asked : rounds_) halved.merge(halve(asked, cured));
    fit_to(halved, cured);
  }

 private:
  // Triangulates and halves for as long as patches ask for it and may.
  void ask() {
    JobShare done(context_, list_);
    while (true) {
      AskedEdges asked(list_.size());
      list_.for_each([&](PatchJob& job, std::size_t index) {
        if (waiting_[index]) asked[index] = job.triangulate(context_, boundary_);
        if (rounds_.empty()) done.add(job);
      });
      for (std::size_t i = 0; i < list_.size(); ++i) {
        waiting_[i] = !asked[i].empty() && (rounds_.size() < kMostForBetter || !list_[i].meshed());
      }
      if (std::find(waiting_.begin(), waiting_.end(), 1) == waiting_.end()) return;
      if (rounds_.size() == kMostHalvings) return;
      halve(asked, waiting_);
      rounds_.push_back(std::move(asked));
    }
  }

  // Halves the edges that the chosen patches ask for, each once; returns them.
  std::set<EdgeId> halve(const AskedEdges& asked, const std::vector<char>& chosen) {
    std::set<EdgeId> edges;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      if (chosen[i]) edges.insert(asked[i].begin(), asked[i].end());
    }
    for (const EdgePair& pair : periodic_) {
      if (edges.count(pair.given) + edges.count(pair.found) == 0) continue;
      edges.insert({pair.given, pair.found});
    }
    halve_edges(context_, evaluator_, {edges.begin(), edges.end()}, boundary_);
    place_alike(evaluator_, periodic_, boundary_);
    return edges;
  }

  // Triangulates the cured patches beside these edges anew.
  void fit_to(const std::set<EdgeId>& halved, const std::vector<char>& cured) {
    list_.for_each([&](PatchJob& job, std::size_t index) {
      const auto beside = [&](EdgeId edge) { return job.borders_on(edge); };
      if (!cured[index] || std::none_of(halved.begin(), halved.end(), beside)) return;
      if (job.finished()) list_.renew(index);
      list_[index].triangulate(context_, boundary_);
    });
  }

  const RunContext& context_;
  Evaluator evaluator_;
  JobList& list_;
  const std::vector<EdgePair>& periodic_;
  Discretization& boundary_;
  std::vector<char> waiting_;       // by patch: to be triangulated in the next round
  std::vector<AskedEdges> rounds_;  // of halving so far
};

}  // namespace

void triangulate_in_rounds(const RunContext& context, const Model& model, JobList& list,
                           const std::vector<EdgePair>& periodic, Discretization& boundary) {
  HalvingRounds(context, model, list, periodic, boundary).run();
}

}  // namespace advlayers
