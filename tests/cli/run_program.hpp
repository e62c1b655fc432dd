// Runs the built program as a user does, or one of its commands within the test, and keeps the output.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"

namespace touchstone::tests {

struct Run {
  int status = -1;  ///< exit status; 128 + N when signal N ended it
  std::string out;
  std::string err;
  long peak_kilobytes = 0;  ///< the largest resident memory
};

struct RunOptions {
  std::string program = {};          ///< empty: touchstone
  std::string folder = {};           ///< working folder; empty: the test's own
  std::string standard_input = {};   ///< a file; empty: the test's own
  std::string standard_output = {};  ///< a file or device to write to; empty: kept in Run::out
  bool closed_pipe = false;          ///< standard output is a pipe whose reader has gone
  std::uint64_t address_space = 0;   ///< bytes of address space that it gets; 0: no limit
  std::uint64_t file_size = 0;       ///< bytes of the largest file that it may write; 0: no limit
  double interrupt_after = 0;        ///< seconds from its set-up until it gets SIGINT; 0: never
  double kill_after = 0;             ///< seconds until it is killed, by SIGKILL; 0: never
  bool own_group = false;            ///< the program leads a process group, and SIGINT goes to the whole group, as
                                     ///< Ctrl-C on a terminal does
};

Run run_program(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// Calls `command` with standard output going to a file. @returns status and output; exceptions pass through
Run run_here(const std::function<int()>& command);

/// The lines of `text`, without their ends.
std::vector<std::string> lines_of(const std::string& text);

/// The first of them, of a text that has one.
inline std::string first_line(const std::string& text) { return lines_of(text).front(); }

/// How often `part` occurs in `text`.
std::size_t occurrences(const std::string& text, const std::string& part);

}  // namespace touchstone::tests
