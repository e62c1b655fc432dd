// The progress of a command that works through query files, or writes them.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/shared/inputs.hpp"
#include "cli/shared/progress/progress_line.hpp"

namespace touchstone::cli {

class QueryProgress {
 public:
  /// @param inputs  the files that are read; none when queries are only written
  explicit QueryProgress(const std::vector<Input>& inputs);

  /// Adds work that has just been done, and draws the line. Call this from one thread at a time.
  void add(std::size_t bytes, std::uint64_t queries);

  /// Wipes the line, so that other lines may follow.
  void wipe() { line_.wipe(); }

  double seconds() const noexcept { return line_.seconds(); }  ///< since construction

 private:
  std::string text() const;

  ProgressLine line_;
  std::optional<std::uint64_t> total_bytes_ = 0;  ///< nothing when a pipe is among the inputs
  std::uint64_t bytes_ = 0;
  std::uint64_t queries_ = 0;
};

}  // namespace touchstone::cli
