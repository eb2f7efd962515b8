#include "geometry/child_process.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <vector>

#include "base/error.h"

namespace advlayers {
namespace {

using Why = ChildFailed::Why;

Why failure(const ChildLimits& limits, const std::function<std::string()>& act) {
  try {
    in_child(limits, act, [] {});
  } catch (const ChildFailed& failed) {
    return failed.why();
  }
  ADD_FAILURE() << "it ended";
  return Why::kNotStarted;
}

TEST(ChildProcess, GivesTheResultAndLeavesMemoryAlone) {
  int value = 1;
  const std::string large(3'000'000, 'x');
  const auto act = [&] {
    value = 2;
    return large + '\0' + "end";
  };
  EXPECT_EQ(in_child({}, act, [] {}), large + '\0' + "end");
  EXPECT_EQ(value, 1);
}

TEST(ChildProcess, ErrorsComeOverWithTheirSentences) {
  const Sentence reason("line {}: {}", 7, Sentence("a number is missing"));
  try {
    in_child(
        {}, [&]() -> std::string { throw InvalidInput("{}: {}", "a{}.step", reason); }, [] {});
    FAIL() << "no error";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(), "a{}.step: line 7: a number is missing");
    EXPECT_EQ(error.sentence().form(), "{}: {}");
    ASSERT_EQ(error.sentence().values().size(), 2u);
    EXPECT_EQ(error.sentence().values()[1].sentence.form(), "line {}: {}");
  }
  EXPECT_THROW(in_child(
                   {}, []() -> std::string { throw GeometryError("no face"); }, [] {}),
               GeometryError);
}

TEST(ChildProcess, TellsOfCrashes) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    const auto die = [signal]() -> std::string { return std::to_string(std::raise(signal)); };
    EXPECT_EQ(failure({}, die), Why::kCrashed) << signal;
  }
  EXPECT_EQ(failure({}, []() -> std::string { _exit(0); }), Why::kCrashed);
}

TEST(ChildProcess, LimitsHold) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers lay out address spaces of their own, which no limit of memory fits";
#endif
  volatile long turns = 0;
  const auto turn = [&]() -> std::string {
    while (true) turns = turns + 1;
  };
  EXPECT_EQ(failure({0.5, std::size_t{1} << 30}, turn), Why::kTooSlow);
  const auto sleep = []() -> std::string {
    while (true) pause();
  };
  EXPECT_EQ(failure({0.1, std::size_t{1} << 30}, sleep), Why::kTooSlow);
  const auto eat = []() -> std::string {
    std::vector<std::string> all;
    while (true) all.emplace_back(1 << 20, 'x');
  };
  EXPECT_EQ(failure({20.0, std::size_t{1} << 26}, eat), Why::kTooLarge);
}

TEST(ChildProcess, ACallerThatStopsLeavesNoChildBehind) {
  const auto sleep = []() -> std::string {
    while (true) pause();
  };
  EXPECT_THROW(in_child({}, sleep, [] { throw Cancelled(); }), Cancelled);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

}  // namespace
}  // namespace advlayers
