// SPDX-License-Identifier: MIT
#include "threads/startable.hpp"

#include <atomic>
#include <cstdlib>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace touchstone::threads {

int startable_threads(int requested) {
  static std::atomic<int> most = 1;
  if (requested <= most) return requested;
  std::atomic<bool> all_there = false;
  std::vector<std::thread> threads;
  const auto wait = [&] {
    void* volatile memory = std::malloc(1);  // the allocator maps memory for each thread
    all_there.wait(false);
    std::free(memory);
  };
  try {
    for (int i = 1; i < requested; ++i) threads.emplace_back(wait);
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  all_there = true;
  all_there.notify_all();
  for (std::thread& thread : threads) thread.join();
  if (static_cast<int>(threads.size()) + 1 < requested) return 1;  // which may be different later
  for (int before = most; before < requested && !most.compare_exchange_weak(before, requested);) continue;
  return requested;
}

}  // namespace touchstone::threads
