// The jobs of a run, one for each patch, and how they run side by side.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "base/run_context.h"
#include "base/side_by_side.h"
#include "mesher/patch_job.h"
#include "sizing/settings.h"

namespace advlayers {

// What it is made of must outlive it.
class JobList {
 public:
  JobList(const RunContext& context, const Model& model, const Settings& settings);

  // Groups the faces by the settings as they stand. A patch that is meshed, and has the same faces
  // as before, stays as it is.
  void make();
  // Begins a meshed patch anew, planned: its boundary has changed.
  void renew(std::size_t index);

  const PatchJobs& jobs() const { return jobs_; }
  PatchJob& operator[](std::size_t index) const { return *jobs_[index]; }
  std::size_t size() const { return jobs_.size(); }
  void clear() { jobs_.clear(); }

  // body(job, index) for each, large patches first. Jobs share nothing that changes, so that
  // neither their order nor the threads show in the result.
  template <class Body>
  void for_each(const Body& body) const {
    side_by_side(order_.size(), threads_, [&](std::size_t i) {
      context_.check();
      body(*jobs_[order_[i]], order_[i]);
    });
  }
  unsigned threads() const { return threads_; }

 private:
  const RunContext& context_;
  const Model& model_;
  const Settings& settings_;
  unsigned threads_;
  PatchJobs jobs_;
  std::vector<std::size_t> order_;
};

// Tells how many of the patches are done, by their areas.
class JobShare {
 public:
  JobShare(const RunContext& context, const JobList& list);
  void add(const PatchJob& job);

 private:
  const RunContext& context_;
  std::mutex mutex_;
  double whole_ = 0.0, done_ = 0.0;
};

}  // namespace advlayers
