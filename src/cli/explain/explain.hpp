// `touchstone explain`: the story of one query's answer.
// SPDX-License-Identifier: MIT
#pragma once

#include "cli/shared/command.hpp"

namespace touchstone::cli {

void add_explain(CLI::App& program, Command& command);

}  // namespace touchstone::cli
