// A program under test that is asked over pipes: a line for each scene, and a line as its reply.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "fuzz/processes/limits.hpp"
#include "fuzz/processes/pipe_run.hpp"

namespace touchstone::fuzz {

/// A program in a process that ends with the calling thread. One that ends, hangs or says what is no reply is started
/// again for the next line.
class LineProcess {
 public:
  /// Starts the program. @throws Error  when it cannot be started
  using Start = std::function<std::unique_ptr<PipeRun>()>;

  /// @throws Error  as `start`
  LineProcess(Start start, const Limits& limits);

  /// Sends a line, with its line feed, and has the reply read. @param read  throws NoReply for words that are no reply
  /// @throws NoReply  when the program ends, hangs, or says too much, and what `read` throws
  void ask(std::string_view line, const std::function<void(std::string_view)>& read);

 private:
  Start start_;
  Limits limits_;
  std::unique_ptr<PipeRun> run_;
  bool is_first_ = true, is_new_ = true;
};

/// Starts a command line.
LineProcess::Start command_start(const std::string& command_line, const Limits& limits);

/// A function that asks a program of its own. @param line_of  the line of the function's arguments
/// @param read  the reply of a line; it throws NoReply for words that are no reply
/// @throws Error  when the program cannot be started
template <class LineOf, class Read>
auto ask_program(const LineProcess::Start& start, const Limits& limits, const LineOf& line_of, const Read& read) {
  const auto process = std::make_shared<LineProcess>(start, limits);
  return [process, line_of, read](const auto&... arguments) {
    decltype(read(std::string_view())) reply;
    process->ask(line_of(arguments...), [&](std::string_view line) { reply = read(line); });
    return reply;
  };
}

}  // namespace touchstone::fuzz
