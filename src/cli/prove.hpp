// `touchstone prove`: a proof of each answer, which another program can check.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/common_options.hpp"

namespace touchstone::cli {

struct ProveOptions : QueryOptions {
  std::string out = "-";
  std::optional<std::uint64_t> theorem;  ///< the one query to prove, as a theorem of Coq
};

int run_prove(const ProveOptions& options);
void add_prove(CLI::App& program, Command& command);

}  // namespace touchstone::cli
