// Inputs that a fuzzer starts from, made by the project's own generators.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::fuzzing {

/// The seeds of the target of this name; the same in every run.
std::vector<std::string> seeds_for(std::string_view target);

}  // namespace touchstone::fuzzing
