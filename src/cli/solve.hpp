// `touchstone solve`: the exact answers to the queries of files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/common_options.hpp"

namespace touchstone::cli {

struct SolveCommandOptions : QueryOptions {
  std::string out = "-";
};

int run_solve(const SolveCommandOptions& options);
void add_solve(CLI::App& program, Command& command);

}  // namespace touchstone::cli
