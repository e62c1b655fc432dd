// The options --separation and --metric.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/separation.hpp>

#include "cli/shared/command.hpp"

namespace touchstone::cli {

struct SeparationOption {
  bool given = false;     ///< Whether the command line has --separation.
  Separation separation;  ///< touching when it is not given
};

/// @param about  what the separation means to the command: "The distance that ..."
void add_separation_options(CLI::App& subcommand, SeparationOption& option, const std::string& about);

/// For messages: "separation 0x1p-3 (0.125), euclidean"; "touching, which is separation 0".
std::string separation_for_person(const Separation& separation);

/// " --separation 0x1p-3 --metric max": the arguments that ask for this separation. Empty for touching.
std::string separation_arguments(const Separation& separation);

}  // namespace touchstone::cli
