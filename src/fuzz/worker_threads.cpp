// SPDX-License-Identifier: MIT
#include "fuzz/worker_threads.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <touchstone/error.hpp>

#include "numbers/doubles/float_environment.hpp"

namespace touchstone::fuzz {

void run_on_threads(std::size_t count, std::atomic<bool>& stop, const std::function<void(std::size_t)>& work,
                    const std::function<bool()>& watch) {
  std::mutex mutex;
  std::condition_variable done;
  std::size_t running = count;
  std::exception_ptr error;
  // Its destruction stops the threads and waits for them, also when `watch` throws.
  struct Threads : std::vector<std::thread> {
    std::atomic<bool>& stop;
    explicit Threads(std::atomic<bool>& flag) : stop(flag) {}
    ~Threads() {
      stop = true;
      join();
    }
    void join() {
      for (std::thread& thread : *this) thread.join();
      clear();
    }
  } threads(stop);
  const auto start = [&](std::size_t i) {
    threads.emplace_back([&, i] {
      std::exception_ptr mine;
      try {
        const numbers::DefaultFloatEnvironment environment;
        work(i);
      } catch (...) {
        mine = std::current_exception();
        stop = true;
      }
      const std::lock_guard lock(mutex);
      if (mine && !error) error = mine;
      --running;
      done.notify_one();
    });
  };
  try {
    for (std::size_t i = 0; i < count; ++i) start(i);
  } catch (const std::system_error& fault) {
    throw Error("only " + std::to_string(threads.size()) + " of " + std::to_string(count) +
                " threads can be started: " + fault.code().message() + "; ask for fewer threads, such as 1");
  }
  bool watched = true;
  std::unique_lock lock(mutex);
  while (!done.wait_for(lock, std::chrono::milliseconds(100), [&] { return running == 0; })) {
    lock.unlock();
    if (watched && !watch()) {
      watched = false;
      stop = true;
    }
    lock.lock();
  }
  lock.unlock();
  threads.join();
  if (error) std::rethrow_exception(error);
}

}  // namespace touchstone::fuzz
