// Long work without the GIL that Ctrl-C ends: in chunks, or one call on a thread of its own.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>

namespace touchstone::python {

/// Lets Python's signal handlers run. @throws error_already_set  with the exception of a handler: KeyboardInterrupt
inline void check_signals() {
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

/// The result of work(), which runs without the GIL.
template <class Work>
auto unlocked(const Work& work) {
  const pybind11::gil_scoped_release released;
  return work();
}

/// Calls work(first, last) without the GIL for chunks that cover [0, count) in order, each of which takes about a
/// twentieth of a second, however long an item takes. The signal handlers run after each.
/// @param first_size  the number of items of the first chunk
template <class Work>
void in_chunks(std::size_t count, std::size_t first_size, const Work& work) {
  using Clock = std::chrono::steady_clock;
  constexpr double kSeconds = 0.05;
  constexpr double kMostGrowth = 16;
  for (std::size_t first = 0, size = first_size; first < count;) {
    const std::size_t last = first + std::min(size, count - first);
    const Clock::time_point start = Clock::now();
    {
      const pybind11::gil_scoped_release released;
      work(first, last);
    }
    check_signals();
    const std::chrono::duration<double> taken = Clock::now() - start;
    const double growth = std::min(kMostGrowth, kSeconds / std::max(taken.count(), 1e-9));
    size = std::max<std::size_t>(1, static_cast<std::size_t>(static_cast<double>(last - first) * growth));
    first = last;
  }
}

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
