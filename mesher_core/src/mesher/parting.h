// Parts patches whose faces cannot be meshed together: the faces at fault become patches of their
// own.
#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "mesher/job_list.h"
#include "sizing/settings.h"

namespace advlayers {

// Makes edges of the faces at fault boundary edges in the settings, and the jobs by these; what is
// not yet meshed then waits for another start. Edges that the user called smooth stay inside their
// patches.
class Parting {
 public:
  // All must outlive it; the list's settings are these.
  Parting(const RunContext& context, const Model& model, Settings& settings, JobList& list);

  // Each returns false where nothing is left to part. Faces that are curved more tightly than
  // layers of the size can follow; before anything is meshed.
  bool part_tight();
  // Faces whose patches could not be triangulated with them cost their neighbours nothing.
  bool part_failed();
  // Faces that the mesh of their patch could not follow: elements reach over them, or found no
  // room.
  bool part_strained();

  const std::vector<Diagnostic>& notes() const { return notes_; }

 private:
  bool part(const std::vector<FaceId>& faces, const Sentence& said);

  const RunContext& context_;
  const Model& model_;
  Settings& settings_;
  JobList& list_;
  std::vector<Diagnostic> notes_;
};

}  // namespace advlayers
