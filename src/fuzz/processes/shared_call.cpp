// SPDX-License-Identifier: MIT
#include "fuzz/processes/shared_call.hpp"

#include <sched.h>
#include <time.h>
#ifdef __linux__
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

#include <algorithm>
#include <thread>

namespace touchstone::fuzz {
namespace {

// Two processes on two cores exchange a word in less than a microsecond. A longer wait should let other threads run.
constexpr int kSpins = 400;
constexpr int kYields = 4;

void relax() noexcept {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

/// Sleeps until wake() is called, a signal comes, or the time is over. Does not sleep when the word has changed.
void sleep_on(const std::atomic<std::uint32_t>& word, std::uint32_t old, std::chrono::nanoseconds time) {
#ifdef __linux__
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  timespec limit{};
  limit.tv_sec = static_cast<time_t>(seconds.count());
  limit.tv_nsec = static_cast<long>((time - seconds).count());
  ::syscall(SYS_futex, &word, FUTEX_WAIT, old, &limit, nullptr, 0);
#else
  if (word.load() == old)
    std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(time, std::chrono::microseconds(50)));
#endif
}

void wake(const std::atomic<std::uint32_t>& word) {
#ifdef __linux__
  ::syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0);
#else
  static_cast<void>(word);
#endif
}

std::atomic<std::uint32_t>& asleep(SharedCall& call, Side side) { return call.asleep[side == Side::parent ? 0 : 1]; }

}  // namespace

bool wait_for_change(SharedCall& call, Side self, const std::atomic<std::uint32_t>& word, std::uint32_t old,
                     std::chrono::nanoseconds time) {
  static const bool alone = std::thread::hardware_concurrency() == 1;  // then spinning only keeps the other one waiting
  for (int i = 0; !alone && i < kSpins; ++i) {
    if (word.load(std::memory_order_acquire) != old) return true;
    relax();
  }
  for (int i = 0; i < kYields; ++i) {
    if (word.load(std::memory_order_acquire) != old) return true;
    ::sched_yield();
  }
  const auto deadline = std::chrono::steady_clock::now() + time;
  auto& flag = asleep(call, self);
  flag.store(1);  // sequentially consistent with raise(): either it sees the flag, or the loop sees the word
  while (word.load() == old) {
    const auto now = std::chrono::steady_clock::now();
    if (now >= deadline) break;
    sleep_on(word, old, deadline - now);
  }
  flag.store(0);
  return word.load(std::memory_order_acquire) != old;
}

void raise(SharedCall& call, Side self, std::atomic<std::uint32_t>& word) {
  word.fetch_add(1);
  if (asleep(call, self == Side::parent ? Side::child : Side::parent).load() != 0) wake(word);
}

}  // namespace touchstone::fuzz
