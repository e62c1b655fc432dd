// Sanitizers and debug builds are an order of magnitude slower than a release build: they run fewer of the same cases.
// A check that a short search or a short simulation cannot meet is left to the release build, with a printed line.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TOUCHSTONE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TOUCHSTONE_SANITIZED 1
#endif
#endif
#ifndef TOUCHSTONE_SANITIZED
#define TOUCHSTONE_SANITIZED 0
#endif

#if defined(__SANITIZE_THREAD__)
#define TOUCHSTONE_THREAD_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define TOUCHSTONE_THREAD_SANITIZED 1
#endif
#endif
#ifndef TOUCHSTONE_THREAD_SANITIZED
#define TOUCHSTONE_THREAD_SANITIZED 0
#endif

#if TOUCHSTONE_SANITIZED || !defined(NDEBUG)
#define TOUCHSTONE_SLOW_BUILD 1
#else
#define TOUCHSTONE_SLOW_BUILD 0
#endif

namespace touchstone::tests {

/// A slow build runs one case in so many.
inline constexpr std::size_t kSlowdown = 20;

/// How many cases to run where a release build runs `count`; TOUCHSTONE_EFFORT=10 asks for ten times as many.
inline std::size_t effort(std::size_t count) {
  if (const char* factor = std::getenv("TOUCHSTONE_EFFORT")) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::atof(factor) * static_cast<double>(count)));
  }
  return TOUCHSTONE_SLOW_BUILD ? (count + kSlowdown - 1) / kSlowdown : count;
}

/// Whether to run the n-th of cases that are a fixed list, each a thing of its own: a slow build or a lesser effort
/// runs some, evenly.
inline bool runs_case(std::size_t n) {
  const std::size_t of_thousand = std::min<std::size_t>(1000, effort(1000));
  return n * of_thousand / 1000 != (n + 1) * of_thousand / 1000;
}

/// Whether the checks apply that need all cases. If they do not, it prints that `what` is not checked.
inline bool whole_effort(const char* what) {
  if (effort(1000) >= 1000) return true;
  std::printf("not checked: %s (this build, or TOUCHSTONE_EFFORT, runs fewer cases)\n", what);
  return false;
}

}  // namespace touchstone::tests
