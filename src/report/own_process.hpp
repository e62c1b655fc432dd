// Work in a process of its own, and the memory that it took there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <type_traits>

namespace touchstone::report {

/// Calls `prepare` and then `work` in a forked process and copies the `size` bytes at `result`, which it fills there,
/// back to here. In a program with several threads both must be careful: only the calling thread lives on in that
/// process.
/// @returns by how many bytes the process's resident memory grew from `work`'s beginning until its peak: all that is
/// touched,
///          with what is freed again and what the allocator holds back; also code that neither `prepare` nor anything
///          before it has used. Nothing where the system does not tell
/// @throws Error  with the words of an exception that leaves them, or when the process ends otherwise
std::optional<std::uint64_t> run_in_own_process(const std::function<void()>& prepare, const std::function<void()>& work,
                                                void* result, std::size_t size);

template <class T>
struct OwnRun {
  T value;
  std::optional<std::uint64_t> memory;  ///< bytes, as above
};

/// The same for what `work` returns.
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
