#include "geometry/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>

#include "base/error.h"
#include "geometry/child_answer.h"

namespace advlayers {
namespace {

using Why = ChildFailed::Why;
using Clock = std::chrono::steady_clock;

constexpr int kPoll = 50;  // [ms]
// A copy that waits for a lock uses no processor: it may take so many times longer by the clock
// than it may compute, which a busy machine needs too.
constexpr double kClockPerComputing = 5.0;

std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void limit(int resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  getrlimit(static_cast<__rlimit_resource>(resource), &now);
  const rlimit less{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  setrlimit(static_cast<__rlimit_resource>(resource), &less);
}

// FreeCAD's and Python's handlers would turn the signals into exceptions, or talk about them.
void die_quietly(const ChildLimits& limits, std::size_t in_use, pid_t parent) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  limit(RLIMIT_CORE, 0, 0);
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
  limit(RLIMIT_CPU, seconds, seconds + 1);
  limit(RLIMIT_AS, in_use + limits.bytes, in_use + limits.bytes);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

void write_all(int pipe, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(pipe, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) _exit(1);
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void answer_and_exit(int pipe, const std::function<std::string()>& act) {
  try {
    write_all(pipe, answer_of_result(act()));
  } catch (const InvalidInput& error) {
    write_all(pipe, answer_of_invalid_input(error.sentence()));
  } catch (const GeometryError& error) {
    write_all(pipe, answer_of_geometry_error(error.sentence()));
  } catch (const std::bad_alloc&) {
    write_all(pipe, answer_out_of_memory());
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

// The parent's side: reads the answer, and leaves no child behind.
class Child {
 public:
  Child(pid_t pid, int pipe) : pid_(pid), pipe_(pipe) {}
  ~Child() {
    close(pipe_);
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      wait_for_end();
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  std::string answer(double seconds, const std::function<void()>& poll_caller) {
    const auto start = Clock::now();
    std::string bytes;
    while (true) {
      pollfd wanted{pipe_, POLLIN, 0};
      if (poll(&wanted, 1, kPoll) > 0 && !read_some(bytes)) return bytes;
      poll_caller();
      if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) {
        throw ChildFailed(Why::kTooSlow, "it does not end");
      }
    }
  }

  int wait_for_end() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
    return status;
  }

 private:
  // False at the end of what there is.
  bool read_some(std::string& bytes) {
    char buffer[1 << 16];
    const ssize_t got = read(pipe_, buffer, sizeof buffer);
    if (got > 0) bytes.append(buffer, static_cast<std::size_t>(got));
    return got > 0 || (got < 0 && errno == EINTR);
  }

  pid_t pid_;
  int pipe_;
};

}  // namespace

std::string in_child(const ChildLimits& limits, const std::function<std::string()>& act,
                     const std::function<void()>& poll) {
  const std::size_t in_use = address_space();
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw ChildFailed(Why::kNotStarted, std::strerror(errno));
  const pid_t parent = getpid(), pid = fork();
  if (pid == 0) {
    close(ends[0]);
    die_quietly(limits, in_use, parent);
    answer_and_exit(ends[1], act);
  }
  const int error = errno;
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    throw ChildFailed(Why::kNotStarted, std::strerror(error));
  }
  Child child(pid, ends[0]);
  const std::string answer = child.answer(kClockPerComputing * limits.seconds + 1.0, poll);
  const int status = child.wait_for_end();
  if (!WIFSIGNALED(status)) return result_of_answer(answer);
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) throw ChildFailed(Why::kTooSlow, "it does not end");
  throw ChildFailed(Why::kCrashed, strsignal(signal));
}

}  // namespace advlayers
