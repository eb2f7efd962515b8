// Doing what may crash, or never end, in a program of its own. What systems do differently there is
// in child_process_posix.cpp alone.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace advlayers {

struct ChildLimits {
  double seconds = 60.0;                     // of computing
  std::size_t bytes = std::size_t{4} << 30;  // beyond what the child has in use when it begins
  double idle_seconds = 60.0;                // by the clock, in which it computes nothing
};

// The child came to no end of its own.
class ChildFailed : public std::runtime_error {
 public:
  enum class Why { kCrashed, kTooSlow, kTooLarge, kNotStarted };
  ChildFailed(Why why, const std::string& what) : std::runtime_error(what), why_(why) {}
  Why why() const { return why_; }

 private:
  Why why_;
};

// What the program command[0] answers to the request by answer_parent(): its result, or the
// InvalidInput or GeometryError that it threw. Throws ChildFailed where it cannot be started,
// crashes, passes the limits or throws anything else. `poll` is called some twenty times a second
// meanwhile; the child is killed where it throws, and ends by itself with this process. The program
// is started afresh: a copy of a process with several threads may wait for ever for a lock that
// one of them has held.
std::string answer_of_child(const std::vector<std::string>& command, const std::string& request,
                            const ChildLimits& limits, const std::function<void()>& poll);

// The child's side, in a program that answer_of_child() has started: reads the request, keeps to
// the limits from here on, and ends the process with the answer. What is printed is lost.
[[noreturn]] void answer_parent(const std::function<std::string(const std::string&)>& act);

// The folder of the library or program that this is linked into; empty where it is not known.
const std::string& own_folder();

std::size_t machine_bytes();  // of memory

}  // namespace advlayers
