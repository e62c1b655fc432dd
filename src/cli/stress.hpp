// `touchstone stress`: where each method breaks as one property of the queries grows worse.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

void add_stress(CLI::App& program, Command& command);

}  // namespace touchstone::cli
