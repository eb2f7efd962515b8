// Long work of the core, called from Python.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <memory>

#include "base/run_context.h"

namespace advlayers::python {

// Runs the work beside the calling thread, which meanwhile looks for Ctrl-C: Python delivers it to
// the main thread alone, and only when asked. The work runs without the interpreter's lock.
template <class Work>
auto run_interruptibly(RunContext& context, const Work& work) {
  constexpr auto kSignalPoll = std::chrono::milliseconds(20);
  std::unique_ptr<pybind11::error_already_set> interrupt;
  std::future<decltype(work())> outcome;
  {
    const pybind11::gil_scoped_release release;
    outcome = std::async(std::launch::async, work);
    while (outcome.wait_for(kSignalPoll) != std::future_status::ready && !interrupt) {
      const pybind11::gil_scoped_acquire acquire;
      if (PyErr_CheckSignals() == 0) continue;
      interrupt = std::make_unique<pybind11::error_already_set>();
      context.cancel();
    }
    outcome.wait();
  }
  if (interrupt) throw pybind11::error_already_set(*interrupt);
  return outcome.get();
}

// The context handed in, or one of the call's own.
inline std::shared_ptr<RunContext> given_or_own(std::shared_ptr<RunContext> context) {
  return context ? std::move(context) : std::make_shared<RunContext>();
}

}  // namespace advlayers::python
