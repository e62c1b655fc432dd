// `touchstone fuzz`: break a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/findings/search_options.hpp"

namespace touchstone::cli {

int run_fuzz(const FuzzCommandOptions& options);
void add_fuzz(CLI::App& program, Command& command);

}  // namespace touchstone::cli
