// `touchstone doctor`: optional parts, and a self-test of the numerical environment.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

/// One line of the self-test.
struct Check {
  std::string name;
  std::string details;  ///< what was checked, or the fault
  bool passed;
};

/// Every check, in order, on this machine.
std::vector<Check> all_checks();

int run_doctor();
void add_doctor(CLI::App& program, Command& command);

}  // namespace touchstone::cli
