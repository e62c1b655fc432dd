// Tells thread sanitizer that oneTBB orders a task after the code that starts it and before the code that waits for it.
// The system's oneTBB is not built with the sanitizer, so the sanitizer cannot see that by itself. Other builds compile
// this to nothing.
// SPDX-License-Identifier: MIT
#pragma once

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TOUCHSTONE_THREAD_SANITIZER 1
#endif
#elif defined(__SANITIZE_THREAD__)
#define TOUCHSTONE_THREAD_SANITIZER 1
#endif
#ifdef TOUCHSTONE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace touchstone::threads {

/// Orders two threads: everything before give() in one happens before everything after take() in the other.
class ThreadHandover {
 public:
#ifdef TOUCHSTONE_THREAD_SANITIZER
  void give() noexcept { __tsan_release(&token_); }
  void take() noexcept { __tsan_acquire(&token_); }

 private:
  char token_ = 0;
#else
  void give() noexcept {}
  void take() noexcept {}
#endif
};

/// Gives where its scope ends, by an exception too.
class GivesAtEnd {
 public:
  explicit GivesAtEnd(ThreadHandover& handover) noexcept : handover_(handover) {}
  ~GivesAtEnd() { handover_.give(); }
  GivesAtEnd(const GivesAtEnd&) = delete;
  GivesAtEnd& operator=(const GivesAtEnd&) = delete;

 private:
  ThreadHandover& handover_;
};

/// Takes where its scope ends, by an exception too.
class TakesAtEnd {
 public:
  explicit TakesAtEnd(ThreadHandover& handover) noexcept : handover_(handover) {}
  ~TakesAtEnd() { handover_.take(); }
  TakesAtEnd(const TakesAtEnd&) = delete;
  TakesAtEnd& operator=(const TakesAtEnd&) = delete;

 private:
  ThreadHandover& handover_;
};

}  // namespace touchstone::threads
