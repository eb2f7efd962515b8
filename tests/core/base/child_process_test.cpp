#include "base/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <atomic>
#include <csignal>
#include <thread>

#include "base/error.h"

namespace advlayers {
namespace {

using Why = ChildFailed::Why;

std::string answer(const std::string& request, const ChildLimits& limits = {}) {
  return answer_of_child({CHILD_FOR_TESTS}, request, limits, [] {});
}

Why failure(const std::string& request, const ChildLimits& limits = {}) {
  try {
    answer(request, limits);
  } catch (const ChildFailed& failed) {
    return failed.why();
  }
  ADD_FAILURE() << "it ended: " << request;
  return Why::kNotStarted;
}

TEST(ChildProcess, GivesTheResultAndLosesWhatIsPrinted) {
  const std::string bytes("a\0b\nend", 7);
  EXPECT_EQ(answer("repeat " + bytes), bytes);
  EXPECT_EQ(answer("large"), std::string(3'000'000, 'x'));
}

TEST(ChildProcess, ErrorsComeOverWithTheirSentences) {
  try {
    answer("invalid");
    FAIL() << "no error";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "a{}.step: line 7: cut off");
    EXPECT_EQ(error.sentence().form(), "{}: {}");
    ASSERT_EQ(error.sentence().values().size(), 2u);
    EXPECT_EQ(error.sentence().values()[1].sentence.form(), "line {}: {}");
  }
  EXPECT_THROW(answer("geometry"), GeometryError);
}

TEST(ChildProcess, TellsOfCrashes) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    EXPECT_EQ(failure("raise " + std::to_string(signal)), Why::kCrashed) << signal;
  }
  EXPECT_EQ(failure("end"), Why::kCrashed);
  EXPECT_EQ(failure("no such word"), Why::kCrashed);
}

TEST(ChildProcess, AProgramThatCannotStartIsNamed) {
  for (const char* path : {"/no/such/program", "/dev/null", "/"}) {
    try {
      answer_of_child({path}, "repeat", {}, [] {});
      ADD_FAILURE() << path;
    } catch (const ChildFailed& failed) {
      EXPECT_EQ(failed.why(), Why::kNotStarted);
      EXPECT_EQ(std::string(failed.what()).rfind(std::string(path) + ": ", 0), 0u) << failed.what();
    }
  }
  EXPECT_EQ(failure(std::string(1 << 20, 'x')), Why::kNotStarted);
}

TEST(ChildProcess, LimitsHold) {
  ChildLimits limits;
  limits.seconds = 0.5;
  EXPECT_EQ(failure("spin", limits), Why::kTooSlow);
  limits.idle_seconds = 0.1;
  EXPECT_EQ(failure("sleep", limits), Why::kTooSlow);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // Sanitizers lay out address spaces of their own, which no limit of memory fits.
  limits.seconds = 20.0;
  limits.bytes = std::size_t{1} << 26;
  EXPECT_EQ(failure("eat", limits), Why::kTooLarge);
#endif
}

TEST(ChildProcess, ACallerThatStopsLeavesNoChildBehind) {
  const auto stop = [] { throw Cancelled(); };
  EXPECT_THROW(answer_of_child({CHILD_FOR_TESTS}, "sleep", {}, stop), Cancelled);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

// A copy of this process would wait for ever for the lock of the memory.
TEST(ChildProcess, OtherThreadsMayHoldLocks) {
  std::atomic<bool> done{false};
  std::thread busy([&done] {
    while (!done) std::string(1000, 'x');
  });
  for (int i = 0; i < 5; ++i) EXPECT_EQ(answer("repeat x"), "x");
  done = true;
  busy.join();
}

}  // namespace
}  // namespace advlayers
