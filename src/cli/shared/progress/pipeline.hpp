// Read in order, work on several threads, write in order, with a bounded number of items under way.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <thread>

#if TOUCHSTONE_WITH_TBB
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include "cli/shared/progress/interrupt.hpp"
#include "threads/startable.hpp"
#include "threads/thread_handover.hpp"

namespace touchstone::cli {

/// The number of threads that a command uses by default: all that the machine has; 1 without oneTBB.
int default_threads() noexcept;

/// `threads`, or default_threads() for 0.
int thread_count(int threads) noexcept;

/// Calls read(item) for new items until it returns false, work(item) for each on any of `threads` threads, and
/// write(item) in the order of reading. The output therefore does not depend on the number of threads.
///
/// That holds for errors too: an exception of read or work is kept in item.error, the item is written as far as it
/// got, and then the exception is thrown here. Reading ends with its first error. An error of work replaces that one,
/// because it concerns an earlier query.
/// @return the number of threads that worked on an item; 1 without items
template <class Item, class Read, class Work, class Write>
int run_in_order(int threads, Read read, Work work, Write write) {
  bool more = true;
  // No exception passes through the pipeline: oneTBB would drop the items that are under way. They drain instead.
  std::exception_ptr failure;
  std::atomic<bool> failed = false;
  const auto read_item = [&]() -> std::shared_ptr<Item> {
    if (!more || failed) return nullptr;
    auto item = std::make_shared<Item>();
    try {
      throw_if_interrupted();
      more = read(*item);
      if (!more) return nullptr;
    } catch (...) {
      item->error = std::current_exception();
      more = false;
    }
    return item;
  };
  std::mutex lock;
  std::set<std::thread::id> workers;
  const auto count_workers = [&] { return std::max(1, static_cast<int>(workers.size())); };
  const auto work_on = [&](Item& item) {
    if (failed) return;
    try {
      {
        const std::lock_guard<std::mutex> guard(lock);
        workers.insert(std::this_thread::get_id());
      }
      throw_if_interrupted();
      work(item);
    } catch (...) {
      item.error = std::current_exception();
    }
  };
  const auto write_item = [&](Item& item) {
    if (failed) return;
    try {
      write(item);
      if (item.error) std::rethrow_exception(item.error);
    } catch (...) {
      failure = std::current_exception();
      failed = true;
    }
  };

#if TOUCHSTONE_WITH_TBB
  threads = threads::startable_threads(threads);
  if (threads > 1) {
    using ItemPointer = std::shared_ptr<Item>;
    const auto count = static_cast<std::size_t>(threads);
    constexpr std::size_t kItemsPerThread = 4;  // bridges a slow item, and keeps memory small
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    tbb::task_arena arena(threads);
    // What oneTBB orders: the serial stages each by themselves, the stages of an item, and all of them between the
    // start and the end.
    threads::ThreadHandover started, reading, items, writing, finished;
    started.give();
    arena.execute([&] {
      tbb::parallel_pipeline(
          kItemsPerThread * count,
          tbb::make_filter<void, ItemPointer>(tbb::filter_mode::serial_in_order, [&](tbb::flow_control& control) {
            started.take();
            reading.take();
            ItemPointer item = read_item();
            if (!item) control.stop();
            reading.give();
            items.give();
            finished.give();
            return item;
          }) & tbb::make_filter<ItemPointer, ItemPointer>(tbb::filter_mode::parallel, [&](ItemPointer item) {
            items.take();
            work_on(*item);
            items.give();
            return item;
          }) & tbb::make_filter<ItemPointer, void>(tbb::filter_mode::serial_in_order, [&](ItemPointer item) {
            items.take();
            writing.take();
            write_item(*item);
            item.reset();
            writing.give();
            finished.give();
          }));
    });
    finished.take();
    if (failure) std::rethrow_exception(failure);
    return count_workers();
  }
#endif
  static_cast<void>(threads);
  while (const auto item = read_item()) {
    work_on(*item);
    write_item(*item);
  }
  if (failure) std::rethrow_exception(failure);
  return count_workers();
}

}  // namespace touchstone::cli
