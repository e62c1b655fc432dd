// Runs the checker of proofs, touchstone-check.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/run_program.hpp"

namespace touchstone::tests {

/// @param words  the options, and the file of proofs
inline Run run_checker(std::vector<std::string> words, const std::vector<std::string>& files) {
  words.insert(words.end(), files.begin(), files.end());
  RunOptions options;
  options.program = TOUCHSTONE_CHECKER;
  return run_program(words, options);
}
inline Run run_checker(const std::string& proofs, const std::vector<std::string>& files) {
  return run_checker(std::vector<std::string>{proofs}, files);
}

}  // namespace touchstone::tests
