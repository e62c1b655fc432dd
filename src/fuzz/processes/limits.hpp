// The time and the amount of text that a solver under test may take for an answer.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace touchstone::fuzz {

/// All times are wall-clock times.
struct Limits {
  std::chrono::milliseconds answer{1000};   ///< from a query to its answer; a solver that takes longer hangs
  std::chrono::milliseconds start{20'000};  ///< from the start of a process to its first sign of life
  std::chrono::milliseconds farewell{200};  ///< from the request to end to the end; then the process is killed
  std::size_t line = 1024;                  ///< bytes of a line that a program answers
  std::uint64_t memory = std::uint64_t{4}
                         << 30;  ///< bytes of address space beyond ours; 0: no limit. Not under sanitizers
};

}  // namespace touchstone::fuzz
