#include "mesher/parting.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "mesher/tight_faces.h"

namespace advlayers {

Parting::Parting(const RunContext& context, const Model& model, Settings& settings, JobList& list)
    : context_(context), model_(model), settings_(settings), list_(list) {}

bool Parting::part_tight() {
  std::set<FaceId> in_company;
  for (const auto& job : list_.jobs()) {
    if (job->faces().size() > 1) in_company.insert(job->faces().begin(), job->faces().end());
  }
  if (in_company.empty()) return false;
  Evaluator evaluator(model_);
  std::vector<FaceId> tight;
  for (const FaceId face : tight_faces(context_, evaluator, settings_)) {
    if (in_company.count(face) > 0) tight.push_back(face);
  }
  return part(tight, Sentence("meshed on their own, as they are curved more tightly than layers of "
                              "this size can follow: {}"));
}

bool Parting::part_failed() {
  std::vector<FaceId> failed;
  for (const auto& job : list_.jobs()) {
    failed.insert(failed.end(), job->failed_faces().begin(), job->failed_faces().end());
  }
  return part(failed, Sentence("meshed on their own, as their patches could not be meshed with "
                               "them: {}"));
}

bool Parting::part_strained() {
  std::vector<FaceId> strained;
  for (const auto& job : list_.jobs()) {
    strained.insert(strained.end(), job->strained_faces().begin(), job->strained_faces().end());
  }
  return part(strained, Sentence("meshed on their own, as the elements of their patches could not "
                                 "follow them: {}"));
}

// `said` is told of the faces that were parted.
bool Parting::part(const std::vector<FaceId>& faces, const Sentence& said) {
  const FeatureRule rule = feature_rule(settings_);
  const auto listed = [](const std::vector<EdgeId>& edges, EdgeId edge) {
    return std::binary_search(edges.begin(), edges.end(), edge);
  };
  std::set<EdgeId> edges;
  std::string names;
  for (const FaceId face : faces) {
    context_.check();
    const std::size_t known = edges.size();
    for (const auto& loop : model_.face(face).loops) {
      for (const CoEdge& coedge : loop) {
        const EdgeId edge = coedge.edge;
        const bool seam = model_.edge(edge).faces.size() < 2;
        if (!seam && !listed(rule.smooth, edge) && !listed(rule.boundary, edge)) edges.insert(edge);
      }
    }
    if (edges.size() > known) names += (names.empty() ? "" : ", ") + face_name(face);
  }
  if (edges.empty()) return false;
  settings_.boundary_edges.insert(settings_.boundary_edges.end(), edges.begin(), edges.end());
  Diagnostic note;
  note.severity = Severity::kInfo;
  note.code = "patch-parted";
  note.sentence = said.about(names);
  notes_.push_back(std::move(note));
  list_.make();
  return true;
}

}  // namespace advlayers
