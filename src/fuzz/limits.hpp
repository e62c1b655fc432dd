// How long other people's solvers are waited for, and how much they may say.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace touchstone::fuzz {

/// All times are wall-clock times.
struct Limits {
  std::chrono::milliseconds answer{1000};   ///< from a query to its answer; after that the solver hangs
  std::chrono::milliseconds start{20'000};  ///< from the start of a process to its first sign of life
  std::chrono::milliseconds farewell{200};  ///< from being told to end to having ended; then it is killed
  std::size_t line = 1024;                  ///< bytes of a line that a program answers
  std::uint64_t memory = std::uint64_t{4}
                         << 30;  ///< bytes of address space beyond ours; 0: as much as it likes. Not under sanitizers
};

}  // namespace touchstone::fuzz
