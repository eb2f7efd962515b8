#include "mesher/job_list.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace advlayers {

JobList::JobList(const RunContext& context, const Model& model, const Settings& settings)
    : context_(context),
      model_(model),
      settings_(settings),
      threads_(useful_threads(settings.threads)) {}

void JobList::make() {
  PatchJobs before = std::exchange(jobs_, {});
  for (std::vector<FaceId>& faces : group_faces(context_, model_, settings_)) {
    context_.check();
    const PatchId id(jobs_.size());
    const auto same = std::find_if(before.begin(), before.end(), [&](const auto& job) {
      return job != nullptr && job->meshed() && job->faces() == faces;
    });
    if (same != before.end()) {
      (*same)->renumber(id);
      jobs_.push_back(std::move(*same));
    } else {
      jobs_.push_back(std::make_unique<PatchJob>(id, std::move(faces), model_, settings_));
    }
  }
  order_.resize(jobs_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::stable_sort(order_.begin(), order_.end(), [this](std::size_t a, std::size_t b) {
    return jobs_[a]->area() > jobs_[b]->area();
  });
}

void JobList::renew(std::size_t index) {
  const PatchJob& old = *jobs_[index];
  jobs_[index] = std::make_unique<PatchJob>(old.id(), old.faces(), model_, settings_);
  jobs_[index]->plan(context_);
}

JobShare::JobShare(const RunContext& context, const JobList& list) : context_(context) {
  for (const auto& job : list.jobs()) whole_ += job->area();
}

void JobShare::add(const PatchJob& job) {
  const std::lock_guard<std::mutex> lock(mutex_);
  done_ += job.area();
  if (whole_ > 0.0) context_.tell_share(done_ / whole_);
}

}  // namespace advlayers
