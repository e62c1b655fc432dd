// Helpers that the tests of plugins and of programs share.
// SPDX-License-Identifier: MIT
#pragma once

#include <signal.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include <touchstone/query.hpp>

#include "fuzz/processes/limits.hpp"
#include "fuzz/solver_under_test.hpp"

namespace touchstone::tests {

/// Short, so that a hang costs little; long enough for a busy machine.
inline fuzz::Limits quick_limits() {
  fuzz::Limits limits;
  limits.answer = std::chrono::milliseconds(1500);
  return limits;
}

/// Two points far apart. The first coordinate chooses the fault of a bad solver.
inline Query order(int what) {
  PointPoint query;
  query.start = {{{static_cast<double>(what), 0, 0}, {100, 0, 0}}};
  query.end = query.start;
  return query;
}

/// Two points that meet at t = 1/2.
inline Query meeting_points() {
  PointPoint query;
  query.start = {{{0, 0, 0}, {1, 1, 1}}};
  query.end = {{{1, 1, 1}, {0, 0, 0}}};
  return query;
}

/// Two edges that cross at t = 1/2.
inline Query crossing_edges() {
  EdgeEdge query;
  query.start = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}};
  query.end = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, -1}, {0, 1, -1}}};
  return query;
}

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Whether no process of this number is left, a moment later at the latest.
inline bool vanishes(int process) {
  for (int i = 0; i < 200; ++i) {
    if (::kill(process, 0) != 0 && errno == ESRCH) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace touchstone::tests
