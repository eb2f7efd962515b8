// Doing what may crash, or never end, in a copy of this process.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace advlayers {

struct ChildLimits {
  double seconds = 60.0;                     // of computing
  std::size_t bytes = std::size_t{4} << 30;  // beyond what this process has in use
};

// The copy came to no end of its own.
class ChildFailed : public std::runtime_error {
 public:
  enum class Why { kCrashed, kTooSlow, kTooLarge, kNotStarted };
  ChildFailed(Why why, const std::string& what) : std::runtime_error(what), why_(why) {}
  Why why() const { return why_; }

 private:
  Why why_;
};

// What `act` returns, or throws of InvalidInput and GeometryError, in a copy of this process: what
// it does to memory stays there, and what it prints is lost. Throws ChildFailed where it crashes,
// passes the limits, throws anything else, or no copy can be made. `poll` is called some twenty
// times a second while the copy works; the copy is killed where it throws, and when this process
// ends. Locks that other threads hold stay closed in the copy, so the caller holds those that `act`
// needs.
std::string in_child(const ChildLimits& limits, const std::function<std::string()>& act,
                     const std::function<void()>& poll);

}  // namespace advlayers
