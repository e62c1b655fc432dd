// One query of a file, as `explain` and `view` find it and tell it.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <touchstone/query.hpp>

#include "cli/shared/command_line/command.hpp"
#include "cli/shared/command_line/separation_options.hpp"
#include "cli/shared/found_query.hpp"
#include "cli/shared/inputs.hpp"
#include "exact/exact.hpp"
#include "io/queries/query_parser.hpp"

namespace touchstone::cli {

/// Which query, and what is asked about it.
struct OneQuery {
  std::string file;
  std::optional<Kind> kind;
  std::uint64_t query = 0;
  double t_max = 1;
  SeparationOption separation;
  io::Decimals decimals = io::Decimals::exact;
  io::Turns turns = io::Turns::as_given;  ///< of the bodies of a curved query
};

/// The options of both commands. They are written into `options`, which must outlive the parser.
void add_one_query_options(CLI::App& subcommand, OneQuery& options);

struct Explanation {
  std::string corners;  ///< whole lines
  std::string text;     ///< whole lines, after the corners
  exact::Story story;
};
Explanation explanation_of(const io::QueryRecord& record, const OneQuery& options);

/// Writes the page of a query. @returns its size in bytes @throws FileError
std::uint64_t write_query_page(const std::string& path, const Input& input, const io::QueryRecord& record,
                               const Explanation& explanation, const OneQuery& options);

}  // namespace touchstone::cli
