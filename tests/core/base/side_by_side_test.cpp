#include "base/side_by_side.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace advlayers {
namespace {

TEST(SideBySide, CallsEachIndexOnce) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    std::vector<int> calls(100, 0);
    side_by_side(calls.size(), threads, [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(100, 1)) << threads << " threads";
  }
  side_by_side(0, 4, [](std::size_t) { FAIL(); });
}

TEST(SideBySide, WorksAtTheSameTime) {
  std::atomic<int> waiting{0};
  side_by_side(3, 3, [&](std::size_t) {
    ++waiting;
    while (waiting < 3) std::this_thread::yield();  // ends only where all three are under way
  });
  EXPECT_EQ(waiting, 3);
}

TEST(SideBySide, ThrowsTheErrorOfTheLowestIndexAndStartsNoMore) {
  std::atomic<int> calls{0};
  const auto fail_from_3 = [&](std::size_t i) {
    ++calls;
    if (i >= 3) throw std::runtime_error(std::to_string(i));
  };
  for (const unsigned threads : {1u, 4u}) {
    calls = 0;
    try {
      side_by_side(1000, threads, fail_from_3);
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "3");
    }
    EXPECT_LE(calls, 3 + static_cast<int>(threads));
  }
}

TEST(SideBySide, TakesNoMoreThreadsThanProcessors) {
  const unsigned all = useful_threads(0);
  EXPECT_GE(all, 1u);
  EXPECT_EQ(useful_threads(1), 1u);
  EXPECT_EQ(useful_threads(100000), all);
}

}  // namespace
}  // namespace advlayers
