// `touchstone fuzz-steps`: break a simulator's collision detection.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <touchstone/fuzz.hpp>

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

struct FuzzStepsOptions {
  bool bodies = false;                 ///< about steps of whole bodies, not of a mesh
  std::string command;                 ///< of the program under test; empty: a plugin, or the library itself
  std::string plugin;                  ///< the shared library under test; empty: none
  double limit = 10;                   ///< seconds that it may take for a reply
  StepFuzzOptions search;              ///< threads 0: all that the machine has; without `stop`
  std::optional<std::uint64_t> cases;  ///< none: as many as there are in the seconds
  std::string a_case;                  ///< this one alone; empty: all
  std::string out;                     ///< a folder for the shrunk steps; empty: none
};

int run_fuzz_steps(const FuzzStepsOptions& options);
void add_fuzz_steps(CLI::App& program, Command& command);

}  // namespace touchstone::cli
