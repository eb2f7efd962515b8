#include "base/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace advlayers {

unsigned useful_threads(int asked) {
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  return asked > 0 ? std::min(static_cast<unsigned>(asked), processors) : processors;
}

void side_by_side(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::vector<std::exception_ptr> errors(count);
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++) {
      try {
        work(i);
      } catch (...) {
        errors[i] = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::future<void>> others;  // waited for where they go out of scope
    for (std::size_t k = 1; k < std::min<std::size_t>(threads, count); ++k) {
      others.push_back(std::async(std::launch::async, take_turns));
    }
    take_turns();
  }
  for (const std::exception_ptr& error : errors) {
    if (error) std::rethrow_exception(error);
  }
}

}  // namespace advlayers
