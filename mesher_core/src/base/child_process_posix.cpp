#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <new>
#include <thread>

#include "base/child_answer.h"
#include "base/child_process.h"
#include "base/error.h"

extern char** environ;

namespace advlayers {
namespace {

using Why = ChildFailed::Why;
using Clock = std::chrono::steady_clock;

constexpr int kPoll = 50, kWatch = 500;  // [ms]
constexpr int kIdle = 3;                 // exit status of a child that computed nothing for long
constexpr double kLeastComputed = 0.02;  // [s] in idle_seconds; watching takes a tenth of that
// The child keeps to its limits by itself; by the clock it may take many times longer on a busy
// machine, and the start of the program comes on top.
constexpr double kClockPerComputing = 50.0, kClockToStart = 120.0;  // [s]

// Before the request: what the child is to keep to.
struct Terms {
  double seconds, idle_seconds;
  std::uint64_t bytes, request;  // `request`: its length
};

void close_end(int& end) {
  if (end >= 0) close(end);
  end = -1;
}

// --- the parent's side

// Both ends of a pipe, out of the way of the standard streams, which may be closed.
struct Pipe {
  Pipe() {
    int made[2];
    if (pipe2(made, O_CLOEXEC) != 0) throw ChildFailed(Why::kNotStarted, std::strerror(errno));
    for (int i = 0; i < 2; ++i) {
      ends[i] = fcntl(made[i], F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
      if (ends[i] >= 0) close(made[i]);
      if (ends[i] < 0) ends[i] = made[i];
    }
  }
  ~Pipe() {
    close_end(ends[0]);
    close_end(ends[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int ends[2] = {-1, -1};
};

// What a program is started with: the pipes as its streams, every signal as the system has it.
class Start {
 public:
  Start(int in, int out) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_adddup2(&files_, in, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files_, out, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&how_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&how_, &none);
    posix_spawnattr_setsigdefault(&how_, &all);
    posix_spawnattr_setflags(&how_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Start() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&how_);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;

  pid_t run(const std::vector<std::string>& command) const {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    pid_t pid = 0;
    const int error = posix_spawn(&pid, words[0], &files_, &how_, words.data(), environ);
    if (error != 0) {
      throw ChildFailed(Why::kNotStarted, command[0] + ": " + std::strerror(error));
    }
    return pid;
  }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t how_;
};

// Written before the program starts, while this process still holds the end that is read: nobody
// can be gone then. A pipe holds some 64 kB, which is more than names of files take.
void put_request(int pipe, const Terms& terms, const std::string& request) {
  std::string bytes(reinterpret_cast<const char*>(&terms), sizeof terms);
  bytes += request;
  fcntl(pipe, F_SETFL, O_NONBLOCK);
  if (write(pipe, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw ChildFailed(Why::kNotStarted, "the request is too long");
  }
}

// Leaves no child behind.
class Child {
 public:
  Child(pid_t pid, int pipe) : pid_(pid), pipe_(pipe) {}
  ~Child() {
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

// --- the child's side

void limit(int resource, double soft, double hard) {
  rlimit now{};
  getrlimit(static_cast<__rlimit_resource>(resource), &now);
  const auto most = [&now](double wanted) {
    return wanted < static_cast<double>(now.rlim_max) ? static_cast<rlim_t>(wanted) : now.rlim_max;
  };
  const rlimit less{most(soft), most(hard)};
  setrlimit(static_cast<__rlimit_resource>(resource), &less);
}

double address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double computed() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// FreeCAD's and Python's handlers would turn the signals into exceptions, or talk about them.
void keep_to(const Terms& terms) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT, SIGXCPU}) {
    std::signal(signal, SIG_DFL);
  }
  limit(RLIMIT_CORE, 0, 0);
  const double seconds = std::ceil(computed() + terms.seconds);
  limit(RLIMIT_CPU, seconds, seconds + 1);
  const double bytes = address_space() + static_cast<double>(terms.bytes);
  limit(RLIMIT_AS, bytes, bytes);
}

// Ends the process when the parent's end of the pipe is gone, and when nothing is computed.
void watch(double idle_seconds) {
  auto since = Clock::now();
  double before = computed();
  while (true) {
    pollfd parent{STDIN_FILENO, 0, 0};  // a pipe without a writer is told unasked
    if (poll(&parent, 1, kWatch) > 0) _exit(1);
    const double idle = std::chrono::duration<double>(Clock::now() - since).count();
    const double now = computed();
    if (now - before > kLeastComputed) {
      since = Clock::now();
      before = now;
    } else if (idle > idle_seconds) {
      _exit(kIdle);
    }
  }
}

void take(char* bytes, std::size_t size) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = read(STDIN_FILENO, bytes + done, size - done);
    if (got == 0 || (got < 0 && errno != EINTR)) _exit(1);
    if (got > 0) done += static_cast<std::size_t>(got);
  }
}

void write_all(int pipe, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(pipe, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) _exit(1);
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

// The pipe, which readers that print must not reach.
int take_output() {
  const int pipe = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  return pipe;
}

// A program's name may be the word that it was called by.
std::string folder_at_start() {
  Dl_info found{};
  char path[PATH_MAX + 1] = {};
  const bool known = dladdr(reinterpret_cast<const void*>(&own_folder), &found) != 0 &&
                     realpath(found.dli_fname, path) != nullptr;
  if (!known && readlink("/proc/self/exe", path, PATH_MAX) < 0) return "";
  return std::string(path, std::strrchr(path, '/'));
}

std::string outcome(const std::function<std::string(const std::string&)>& act,
                    const std::string& request) {
  try {
    return answer_of_result(act(request));
  } catch (const InvalidInput& error) {
    return answer_of_invalid_input(error.sentence());
  } catch (const GeometryError& error) {
    return answer_of_geometry_error(error.sentence());
  } catch (const std::bad_alloc&) {
    return answer_out_of_memory();
  } catch (...) {
    _exit(1);
  }
}

// Asked when this is loaded: the name may be relative to a folder that the process leaves later.
const std::string& loaded_from = own_folder();

}  // namespace

std::string answer_of_child(const std::vector<std::string>& command, const std::string& request,
                            const ChildLimits& limits, const std::function<void()>& poll) {
  Pipe to_child, from_child;
  put_request(to_child.ends[1], {limits.seconds, limits.idle_seconds, limits.bytes, request.size()},
              request);
  Child child(Start(to_child.ends[0], from_child.ends[1]).run(command), from_child.ends[0]);
  close_end(to_child.ends[0]);
  close_end(from_child.ends[1]);
  const std::string answer =
      child.answer(kClockToStart + kClockPerComputing * limits.seconds, poll);
  const int status = child.wait_for_end();
  if (WIFEXITED(status) && WEXITSTATUS(status) == kIdle) {
    throw ChildFailed(Why::kTooSlow, "it waits without end");
  }
  if (!WIFSIGNALED(status)) return result_of_answer(answer);
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) throw ChildFailed(Why::kTooSlow, "it does not end");
  throw ChildFailed(Why::kCrashed, strsignal(signal));
}

void answer_parent(const std::function<std::string(const std::string&)>& act) {
  const int pipe = take_output();
  Terms terms{};
  take(reinterpret_cast<char*>(&terms), sizeof terms);
  std::string request(terms.request, '\0');
  take(request.data(), request.size());
  std::thread(watch, terms.idle_seconds).detach();
  keep_to(terms);
  write_all(pipe, outcome(act, request));
  _exit(0);
}

const std::string& own_folder() {
  static const std::string folder = folder_at_start();
  return folder;
}

std::size_t machine_bytes() {
  return static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

}  // namespace advlayers
