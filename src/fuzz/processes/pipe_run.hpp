// One run of a program that answers over pipes: lines in, lines out, and no way to make us wait.
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/processes/child_process.hpp"
#include "fuzz/processes/limits.hpp"

namespace touchstone::fuzz {

class PipeRun {
 public:
  /// @throws Error when it cannot be started: "no such program", say
  PipeRun(const std::string& command_line, const Limits& limits);

  /// A function in place of a program, with the same standard input and output. It runs as ChildProcess has it run.
  PipeRun(const std::function<void()>& serve, const Limits& limits);

  /// Closes its input, which tells it to end, and waits a little.
  ~PipeRun();
  PipeRun(const PipeRun&) = delete;
  PipeRun& operator=(const PipeRun&) = delete;

  struct Exchange {
    enum class End : std::uint8_t { line, died, late, too_long, unasked };
    End end;
    std::string line;  ///< without its line feed; incomplete when the line feed has not come
  };

  /// Sends a line (with its line feed) and waits for one.
  Exchange exchange(std::string_view line, std::chrono::milliseconds time);

  /// Closes its input and reads all that it writes until it ends with exit status 0.
  /// @throws Error  with the reason when it ends otherwise, writes more than `most` bytes, or takes longer than `time`
  std::string read_all(std::chrono::milliseconds time, std::size_t most);

  ChildProcess& child() noexcept { return *child_; }

  /// How often exchange() has waited in vain, until its time was over.
  std::uint64_t idle_waits() const noexcept { return idle_waits_; }

 private:
  /// @param spare  a further descriptor that stays open in the child
  void start(const std::function<void()>& serve, int spare);
  bool take_line(std::string& line);
  bool read_some();
  bool write_some(std::string_view& rest);

  Limits limits_;
  Pipe in_, out_;
  std::optional<ChildProcess> child_;
  std::string buffer_;   ///< read, but not yet a whole line
  bool closed_ = false;  ///< it has closed its output
  std::uint64_t idle_waits_ = 0;
};

}  // namespace touchstone::fuzz
