#include "base/run_context.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace advlayers {

const char* stage_name(RunStage stage) {
  static constexpr std::array<const char*, kRunStages> kNames{
      "", "read", "boundary", "triangulate", "layers", "core"};
  return kNames[static_cast<std::size_t>(stage)];
}

RunContext::RunContext(Clock clock) : clock_(std::move(clock)) {}

double RunContext::wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Progress RunContext::progress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return progress_;
}

void RunContext::tell_share(double share) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  progress_.share = std::clamp(share, progress_.share, 1.0);
}

double RunContext::seconds(RunStage stage) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return seconds_[static_cast<std::size_t>(stage)];
}

double RunContext::begin(RunStage stage) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (stage != progress_.stage) progress_ = {stage, 0.0};
  return clock_();
}

void RunContext::end(RunStage stage, double since) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  seconds_[static_cast<std::size_t>(stage)] += clock_() - since;
}

}  // namespace advlayers
