// A request to stop, set from any thread and polled inside loops.
#pragma once

#include <atomic>

#include "base/error.h"

namespace advlayers {

class CancelFlag {
 public:
  void request() { requested_.store(true, std::memory_order_relaxed); }
  bool requested() const { return requested_.load(std::memory_order_relaxed); }
  // Throws Cancelled once a stop was asked for.
  void check() const {
    if (requested()) throw Cancelled();
  }

 private:
  std::atomic<bool> requested_{false};
};

}  // namespace advlayers
