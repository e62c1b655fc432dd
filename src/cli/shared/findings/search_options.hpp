// What a search for failures of one solver asks, and where its findings go.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/findings/solvers.hpp"
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
  std::string repeat;                    ///< the command that asks a file's queries again; empty: touchstone fuzz
};

}  // namespace touchstone::cli
