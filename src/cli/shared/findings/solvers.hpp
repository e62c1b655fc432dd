// From the command line to a solver under test.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/shared/command_line/separation_options.hpp"
#include "fuzz/engine.hpp"

namespace touchstone::cli {

/// The values of `--solver` and `--solver-command`, of which at most one is given.
struct SolverChoice {
  std::string solver =
      "touchstone";         ///< a name, or the path of a plugin: whatever has a slash or ends in .so or .dylib
  std::string command;      ///< of a program that is fed over pipes; empty: none
  double limit = 1;         ///< seconds that a plugin or program may take for an answer
  bool any_memory = false;  ///< as much as it likes: the programs of node reserve more than they use
};

/// Makes one solver for each thread, for the separation. No other function knows where solvers come from.
/// @throws Error  when there is no such solver
fuzz::SolverFactory solver_factory(const SolverChoice& choice, const SeparationOption& separation);

/// The options that choose it again: "--solver paper".
std::string solver_options(const SolverChoice& choice);

}  // namespace touchstone::cli
