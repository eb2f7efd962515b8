#include "geometry/child_process.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>

namespace advlayers {
namespace {

constexpr unsigned kPatience = 60;  // [s]

// FreeCAD's handlers would turn the signals into exceptions, or talk about them.
void die_quietly() {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, SIG_DFL);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  std::signal(SIGALRM, SIG_DFL);
  alarm(kPatience);
}

}  // namespace

bool survives(const std::function<void()>& act) {
  const pid_t child = fork();
  if (child < 0) return true;
  if (child == 0) {
    die_quietly();
    try {
      act();
    } catch (...) {  // the same comes again in the process that asks
      _exit(0);
    }
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return !WIFSIGNALED(status) || WTERMSIG(status) == SIGALRM;
}

}  // namespace advlayers
