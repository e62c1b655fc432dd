// Runs the checker of proofs, touchstone-check.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/run_program.hpp"

namespace touchstone::tests {

inline Run run_checker(const std::string& proofs, const std::vector<std::string>& files) {
  std::vector<std::string> arguments = {proofs};
  arguments.insert(arguments.end(), files.begin(), files.end());
  RunOptions options;
  options.program = TOUCHSTONE_CHECKER;
  return run_program(arguments, options);
}

}  // namespace touchstone::tests
