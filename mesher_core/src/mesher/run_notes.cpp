#include "mesher/run_notes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "sizing/initial_nodes.h"

namespace advlayers {

void note_idle_walls(const Settings& settings, const PatchJobs& jobs,
                     std::vector<Diagnostic>& diagnostics) {
  std::set<EdgeId> asked;
  for (const WallSpec& spec : settings.walls) asked.insert(spec.edges.begin(), spec.edges.end());
  for (const EdgeId edge : asked) {
    const bool bounds = std::any_of(jobs.begin(), jobs.end(), [edge](const auto& job) {
      return job->meshed() && job->borders_on(edge);
    });
    if (bounds) continue;
    Diagnostic diagnostic;
    diagnostic.code = "wall-inside";
    diagnostic.sentence = Sentence(
        "{} bounds no meshed patch, and no layers grow from it; listed in boundary, it bounds its "
        "faces",
        edge_name(edge));
    diagnostics.push_back(std::move(diagnostic));
  }
}

void note_initial_mesh(const Settings& settings, const PatchJobs& jobs,
                       std::vector<Diagnostic>& diagnostics) {
  const InitialNodes* initial = settings.initial_nodes.get();
  if (initial == nullptr) return;
  std::size_t offered = 0;
  int taken = 0;
  for (const auto& job : jobs) {
    for (const FaceId face : job->faces()) offered += initial->on(face).size();
    taken += job->initial_nodes();
  }
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kInfo;
  diagnostic.code = "initial-mesh";
  diagnostic.sentence = Sentence(
      "the triangulation took {} of the {} nodes of the initial mesh; the others lie on edges or "
      "too near to their neighbours",
      taken, offered);
  diagnostics.push_back(diagnostic);
  if (initial->moved() == 0) return;
  diagnostic.code = "initial-mesh-moved";
  diagnostic.sentence = Sentence(
      "{} nodes of the initial mesh lay off the shape, by up to {} mm, and were put onto it",
      initial->moved(), initial->farthest());
  diagnostics.push_back(std::move(diagnostic));
}

void note_sewing(const Model& model, std::vector<Diagnostic>& diagnostics) {
  if (!model.sewn()) return;
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kInfo;
  diagnostic.code = "sewn";
  diagnostic.sentence = Sentence("sewing joined {} edges; free edges left: {}",
                                 model.joined_edges(), model.free_edges());
  diagnostics.push_back(std::move(diagnostic));
}

}  // namespace advlayers
