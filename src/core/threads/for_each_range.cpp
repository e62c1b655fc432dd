// SPDX-License-Identifier: MIT
#include "threads/for_each_range.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "numbers/doubles/float_environment.hpp"
#include "threads/startable.hpp"
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

/// Arenas that no call has taken, by their number of threads. They are used again and never destroyed: oneTBB 2021.8
/// does not give back all memory of an arena that is destroyed, several KB each where the machine is busy.
class Arenas {
 public:
  std::unique_ptr<tbb::task_arena> take(int threads) {
    const std::lock_guard lock(mutex_);
    auto& free = free_[threads];
    if (free.empty()) return std::make_unique<tbb::task_arena>(threads);
    auto arena = std::move(free.back());
    free.pop_back();
    return arena;
  }
  void give_back(int threads, std::unique_ptr<tbb::task_arena> arena) {
    const std::lock_guard lock(mutex_);
    free_[threads].push_back(std::move(arena));
  }

 private:
  std::mutex mutex_;
  std::map<int, std::vector<std::unique_ptr<tbb::task_arena>>> free_;
};

Arenas& arenas() {
  static Arenas* const all = new Arenas;  // threads may still use it when the program's statics are destroyed
  return *all;
}

/// An arena that is the caller's alone for a while.
class TakenArena {
 public:
  explicit TakenArena(int threads) : threads_(threads), arena_(arenas().take(threads)) {}
  TakenArena(const TakenArena&) = delete;
  TakenArena& operator=(const TakenArena&) = delete;
  ~TakenArena() { arenas().give_back(threads_, std::move(arena_)); }

  tbb::task_arena* operator->() const noexcept { return arena_.get(); }

 private:
  int threads_;
  std::unique_ptr<tbb::task_arena> arena_;
};

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
  if (threads > 1 && count > block) threads = startable_threads(threads);
  if (threads > 1 && count > block) {
    const TakenArena arena(threads);
    ThreadHandover started, finished;
    const TakesAtEnd waited(finished);
    started.give();
    arena->execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, block),
                        [&](const tbb::blocked_range<std::size_t>& range) {
                          started.take();
                          const GivesAtEnd done(finished);
                          in_environment(range.begin(), range.end());
                        });
    });
    return;
  }
#else
  static_cast<void>(block);
  static_cast<void>(threads);
#endif
  in_environment(0, count);
}

}  // namespace touchstone::threads
