// A line on standard error that says how far a command has come; only when that is a terminal.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cli/shared/inputs.hpp"

namespace touchstone::cli {

class Progress {
 public:
  explicit Progress(const std::vector<Input>& inputs);
  ~Progress();  ///< wipes the line

  /// So much more is done. Called from one thread at a time.
  void add(std::size_t bytes, std::uint64_t queries);

  std::uint64_t queries() const noexcept { return queries_; }
  double seconds() const noexcept;  ///< since construction

  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  void draw() const;

  bool visible_;
  bool drawn_ = false;
  std::optional<std::uint64_t> total_bytes_ = 0;  ///< nothing when a pipe is among the inputs
  std::uint64_t bytes_ = 0;
  std::uint64_t queries_ = 0;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_ = start_;
};

}  // namespace touchstone::cli
