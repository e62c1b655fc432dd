// `touchstone merge`: the reports of the shards of an animation, put together.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"
#include "io/answers/answer_writer.hpp"

namespace touchstone::cli {

struct MergeOptions {
  std::vector<std::string> reports;
  std::string out, pairs;
  io::Numbers numbers = io::Numbers::decimals;  ///< of pairs
};

int run_merge(const MergeOptions& options);
void add_merge(CLI::App& program, Command& command);

}  // namespace touchstone::cli
