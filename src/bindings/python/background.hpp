// One long call without the GIL, on a thread of its own, while this one hears Ctrl-C.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>

#include "python/chunks.hpp"

namespace touchstone::python {

/// The result of work(stop), which runs without the GIL. If a signal handler throws, as that of Ctrl-C does, `stop`
/// becomes true, and the handler's exception is thrown when the work has ended. The work may set it, too.
/// @param size  of the problem: with few vertices the work is short, and needs no thread of its own
template <class Work>
auto in_background(std::size_t size, const Work& work) {
  constexpr std::size_t kShort = 4096;
  constexpr auto kPatience = std::chrono::milliseconds(50);
  std::atomic<bool> stop = false;
  if (size < kShort) {
    const pybind11::gil_scoped_release released;
    return work(stop);
  }
  std::packaged_task task([&] { return work(stop); });
  auto result = task.get_future();
  std::jthread thread;
  try {
    thread = std::jthread([&] { task(); });
  } catch (const std::system_error&) {  // no thread can be started: the work ends before Ctrl-C is heard
    const pybind11::gil_scoped_release released;
    task();
  }
  while (true) {
    {
      const pybind11::gil_scoped_release released;
      if (result.wait_for(kPatience) == std::future_status::ready) break;
    }
    try {
      check_signals();
    } catch (...) {
      stop = true;
      const pybind11::gil_scoped_release released;
      result.wait();
      throw;
    }
  }
  return result.get();
}

}  // namespace touchstone::python
