// `touchstone report`: the error of every method against its run time, as tables and plots.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

void add_report(CLI::App& program, Command& command);

}  // namespace touchstone::cli
