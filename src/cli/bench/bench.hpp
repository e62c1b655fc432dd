// `touchstone bench`: the time of an answer, as a ratio to the least work that any solver does with a query.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <touchstone/query.hpp>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"

namespace touchstone::cli {

struct BenchOptions {
  std::vector<std::string> files;
  std::optional<Kind> kind;  ///< of the files' queries
  std::string filter;        ///< a regular expression; empty: everything
  int repetitions = 5;
  double min_time = 0.05;  ///< seconds a repetition
  SeparationOption separation;
  std::size_t count = 4000;  ///< queries of each kind and source, about
  std::string csv;           ///< empty: none
  std::string json;          ///< empty: none
};

int run_bench(const BenchOptions& options);
void add_bench(CLI::App& program, Command& command);

}  // namespace touchstone::cli
