// The steps, of a mesh or of whole bodies, on which a program under test is wrong: how they are found and shown.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/fuzz/fuzz_steps.hpp"
#include "fuzz/scenes/scene_search.hpp"

namespace touchstone::cli {

struct FoundStep {
  std::string text;                                        ///< the finding for a person
  std::string case_name;                                   ///< of the step before it was shrunk
  std::string name;                                        ///< "free-missed"
  std::vector<std::pair<std::string, std::string>> files;  ///< what its name is followed by, and the text
  std::function<std::string(const std::string&)> show;     ///< the command that shows it; of the folder and its name
};

struct FoundSteps {
  std::uint64_t steps = 0, failures = 0;
  std::size_t kinds_of_failure = 0;
  bool stopped = false;
  std::vector<FoundStep> found;
};

/// The names of the families.
std::vector<std::string_view> families_of_steps(bool bodies);

/// Asks the program of the options, or the library. @param search  the options' own, with all defaults settled
/// @throws Error  for a program that cannot be started, before any step
FoundSteps find_steps(const FuzzStepsOptions& options, const StepFuzzOptions& search, const fuzz::SceneWatch& watch);

}  // namespace touchstone::cli
