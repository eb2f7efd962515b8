#include "geometry/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace advlayers {
namespace {

TEST(ChildProcess, TellsOfADeathBySignal) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE}) {
    EXPECT_FALSE(survives([signal] { std::raise(signal); })) << signal;
  }
}

TEST(ChildProcess, AnEndOrAnExceptionIsNoDeath) {
  int value = 1;
  EXPECT_TRUE(survives([&value] { value = 2; }));
  EXPECT_EQ(value, 1);
  EXPECT_TRUE(survives([] { throw std::runtime_error("refused"); }));
}

}  // namespace
}  // namespace advlayers
