// Trying what may crash in a copy of this process.
#pragma once

#include <functional>

namespace advlayers {

// Whether `act` comes to its end, in success or by an exception, in a copy of this process: what it
// does to memory stays there, and what it prints is lost. False where a signal killed the copy.
// True, as nothing is known, where no copy can be made, or it has not ended after a minute: locks
// that other threads hold stay closed in the copy, so the caller holds those that `act` needs.
bool survives(const std::function<void()>& act);

}  // namespace advlayers
