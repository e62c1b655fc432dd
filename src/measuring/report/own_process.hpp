// Work in a process of its own, and the memory that the work takes there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

namespace touchstone::report {

/// Calls `prepare` and then `work` in a forked process. `work` fills the `size` bytes at `result` there, and they are
/// copied back into this process. In a program with several threads both must be careful: only the calling thread lives
/// on in the forked process.
/// @returns the growth of the process's resident memory in bytes, from the start of `work` to its peak. That is all
///          memory that is touched, also memory that is freed again or that the allocator keeps, and also code that
///          runs for the first time. Nothing when the system does not report it.
/// @throws Error  with the message of an exception that leaves them, or when the process ends in another way
std::optional<std::uint64_t> run_in_own_process(const std::function<void()>& prepare, const std::function<void()>& work,
                                                void* result, std::size_t size);

template <class T>
struct OwnRun {
  T value;
  std::optional<std::uint64_t> memory;  ///< bytes, as above
};

/// The same for the value that `work` returns.
template <class Work>
auto run_in_own_process(const std::function<void()>& prepare, const Work& work) {
  using T = std::invoke_result_t<Work>;
  static_assert(std::is_trivially_copyable_v<T>);
  OwnRun<T> run{};
  run.memory = run_in_own_process(
      prepare, [&] { run.value = work(); }, &run.value, sizeof run.value);
  return run;
}

}  // namespace touchstone::report
