// What a run shares with whoever started it: the request to stop, how far it is, and its times.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>

#include "base/error.h"

namespace advlayers {

enum class RunStage : std::uint8_t { kNone, kRead, kBoundary, kTriangulate, kLayers, kCore };
inline constexpr std::size_t kRunStages = 6;
const char* stage_name(RunStage stage);  // "read", …; empty before the first

struct Progress {
  RunStage stage = RunStage::kNone;
  double share = 0.0;  // of the stage, 0 … 1
};

// Made for one run, before its CAD file is read; the first argument of every stage. May be asked
// and told from any thread. To tell it is const: that changes nothing of the run.
class RunContext {
 public:
  using Clock = std::function<double()>;  // [s] since some moment

  explicit RunContext(Clock clock = wall_clock);
  RunContext(const RunContext&) = delete;
  RunContext& operator=(const RunContext&) = delete;

  // For good. Every loop that can take 10 ms looks for it.
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }
  // Throws Cancelled once a stop was asked for.
  void check() const {
    if (cancelled()) throw Cancelled();
  }

  Progress progress() const;
  void tell_share(double share) const;
  double seconds(RunStage stage) const;  // spent in it so far, all its times together

  static double wall_clock();

 private:
  friend class StageScope;
  double begin(RunStage stage) const;
  void end(RunStage stage, double since) const;

  Clock clock_;
  std::atomic<bool> cancelled_{false};
  mutable std::mutex mutex_;  // guards what follows
  mutable Progress progress_;
  mutable std::array<double, kRunStages> seconds_{};
};

// The run is in this stage for as long as this lives. Stages follow each other, none within
// another.
class StageScope {
 public:
  StageScope(const RunContext& context, RunStage stage)
      : context_(context), stage_(stage), since_(context.begin(stage)) {}
  ~StageScope() { context_.end(stage_, since_); }
  StageScope(const StageScope&) = delete;
  StageScope& operator=(const StageScope&) = delete;

 private:
  const RunContext& context_;
  RunStage stage_;
  double since_;
};

}  // namespace advlayers
