// SPDX-License-Identifier: MIT
#include "threads/for_each_range.hpp"

#include <map>
#include <string>

#include <touchstone/error.hpp>

#include "numbers/float_environment.hpp"
#include "threads/thread_handover.hpp"

#ifdef TOUCHSTONE_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace touchstone::threads {

#ifdef TOUCHSTONE_WITH_TBB
namespace {

/// The calling thread's arena for so many threads. It is kept until the thread ends: oneTBB 2021.8 does not give back all
/// memory of an arena that is destroyed, several KB each where the machine is busy.
tbb::task_arena& arena_of(int threads) {
  thread_local std::map<int, tbb::task_arena> arenas;
  return arenas.try_emplace(threads, threads).first->second;
}

}  // namespace
#endif

void validate_threads(int threads) {
  if (threads >= 0 && threads <= kMostThreads) return;
  throw InvalidQuery("threads is " + std::to_string(threads) + "; it must be in [0, " + std::to_string(kMostThreads) +
                     "], 0 for as many as the machine has");
}

void for_each_range(std::size_t count, std::size_t block, int threads,
                    const std::function<void(std::size_t first, std::size_t last)>& work) {
  if (count == 0) return;
  const auto in_environment = [&](std::size_t first, std::size_t last) {
    const numbers::DefaultFloatEnvironment environment;  // each thread has its own
    work(first, last);
  };
#ifdef TOUCHSTONE_WITH_TBB
  if (threads == 0) threads = tbb::info::default_concurrency();
  if (threads > 1 && count > block) {
    ThreadHandover started, finished;
    started.give();
    arena_of(threads).execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, block),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          started.take();
                          in_environment(range.begin(), range.end());
                          finished.give();
                        });
    });
    finished.take();
    return;
  }
#else
  static_cast<void>(block);
  static_cast<void>(threads);
#endif
  in_environment(0, count);
}

}  // namespace touchstone::threads
