// `touchstone describe`, which --help does not show: the man page and the shells' completions, for the installation.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

/// Adds the command. It describes every other command of `program`, when it runs.
void add_describe(CLI::App& program, Command& command);

}  // namespace touchstone::cli
