// `touchstone explain` and `touchstone view`: the story of one query's answer, as text and as a page.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

void add_explain(CLI::App& program, Command& command);
void add_view(CLI::App& program, Command& command);

}  // namespace touchstone::cli
