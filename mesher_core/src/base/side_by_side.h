// Work shared out over threads; nothing of it shows which thread did what.
#pragma once

#include <cstddef>
#include <functional>

namespace advlayers {

// Threads that gain something: as many as asked for (0: all), at most one per processor.
unsigned useful_threads(int asked);

// Calls work(0) ... work(count - 1), started in this order, on the caller's thread and up to
// threads - 1 others. Once a call has thrown no more are started, and when the started ones have
// ended the error of the lowest index is thrown on.
void side_by_side(std::size_t count, unsigned threads,
                  const std::function<void(std::size_t)>& work);

}  // namespace advlayers
