// The options --separation and --metric.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <touchstone/separation.hpp>

#include "cli/shared/command_line/command.hpp"

namespace touchstone::cli {

struct SeparationOption {
  bool given = false;     ///< Whether the command line has --separation.
  Separation separation;  ///< touching when it is not given
  bool each = false;      ///< each query has a distance of its own; separation.distance is then 1
};

enum class EachQuery : bool { refused, allowed };

/// @param about  what the separation means to the command: "The distance that ..."
/// @param each  whether "each" is a value: each query with a distance of its own
void add_separation_options(CLI::App& subcommand, SeparationOption& option, const std::string& about,
                            EachQuery each = EachQuery::refused);

/// For messages: "separation 0x1p-3 (0.125), euclidean"; "touching, which is separation 0".
std::string separation_for_person(const Separation& separation);

/// " --separation each --metric max".
std::string each_separation_arguments(Metric metric);

/// " --separation 0x1p-3 --metric max": the arguments that ask for this separation. Empty for touching.
std::string separation_arguments(const Separation& separation);

}  // namespace touchstone::cli
