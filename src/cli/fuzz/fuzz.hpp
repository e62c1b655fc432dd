// `touchstone fuzz`: break a solver.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/fuzz/solvers.hpp"
#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "fuzz/engine.hpp"

namespace touchstone::cli {

struct FuzzCommandOptions {
  SolverChoice solver;
  fuzz::Settings settings;  ///< threads 0: all that the machine has; its separation is not set here
  SeparationOption separation;
  std::vector<std::string> from;         ///< query files to start from; empty: families
  std::string out;                       ///< a folder for the shrunk failures; empty: none
  std::string html;                      ///< a page with the findings; empty: none
  std::optional<fuzz::CaseName> a_case;  ///< this one alone
};

int run_fuzz(const FuzzCommandOptions& options);
void add_fuzz(CLI::App& program, Command& command);

}  // namespace touchstone::cli
