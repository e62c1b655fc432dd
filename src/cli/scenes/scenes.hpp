// `touchstone scenes`: the public scenes, judged and timed.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

struct ScenesOptions {
  std::vector<std::string> folders;
  int threads = 1;  ///< 0: all that the machine has
  std::string csv;  ///< the table's file; empty: none
};

/// @returns the exit status
int run_scenes(const ScenesOptions& options);

void add_scenes(CLI::App& program, Command& command);

}  // namespace touchstone::cli
