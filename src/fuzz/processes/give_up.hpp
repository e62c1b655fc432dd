// The end of a solver's process that can no longer be asked.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "fuzz/solver_under_test.hpp"

namespace touchstone::fuzz {

/// Kills the process of a run that is of no more use, and forgets the run. A program that has lost count of the lines,
/// for example, would answer the wrong query from now on. @returns the reply that says why
template <class Run>
Reply give_up(std::unique_ptr<Run>& run, Reply::State state, std::string detail) {
  if (run) run->child().kill();
  run.reset();
  return no_answer(state, std::move(detail));
}

}  // namespace touchstone::fuzz
