// `touchstone solve`: the exact answers to the queries of files.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/common_options.hpp"
#include "io/answers/answer_writer.hpp"

namespace touchstone::cli {

struct SolveCommandOptions : QueryOptions {
  std::string out = "-";
  io::Numbers numbers = io::Numbers::decimals;
  bool json = false;  ///< lines of JSON in place of CSV
};

int run_solve(const SolveCommandOptions& options);
void add_solve(CLI::App& program, Command& command);

}  // namespace touchstone::cli
