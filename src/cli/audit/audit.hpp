// `touchstone audit`: what the engines that people use say to the same queries, and what is true.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/shared/command_line/command.hpp"
#include "fuzz/settings.hpp"

namespace touchstone::cli {

struct AuditOptions {
  std::vector<std::string> engines;   ///< names to ask, "fcl" or "fcl/linear"; empty: all
  std::vector<std::string> commands;  ///< further engines, "NAME=COMMAND"
  std::vector<std::string> from;      ///< query files to ask instead of families
  std::string out;                    ///< a folder for the table and the shrunk failures
  std::string html;                   ///< a page with the findings; empty: none
  std::uint64_t cases = 100'000;      ///< of each question and kind
  fuzz::Settings settings;            ///< kinds, families, seed, threads
};

int run_audit(const AuditOptions& options);
void add_audit(CLI::App& program, Command& command);

}  // namespace touchstone::cli
