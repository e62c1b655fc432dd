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

/// The files with a picture of a query. Empty names: none; "-": standard output.
struct QueryPictures {
  std::string page{};
  std::string page_option{};  ///< the option that names the page
  std::string svg{};          ///< of a moving picture alone

  void add_options(CLI::App& subcommand, const std::string& page_description);
  /// @throws Error, FileError  where a name is that of an input, of standard output but may not be, or of both files
  void check(const OneQuery& query, bool standard_output_is_free) const;
  /// @returns a line for a person about each file that is not standard output @throws FileError
  std::string write(const Input& input, const io::QueryRecord& record, const Explanation& explanation,
                    const OneQuery& query) const;
};

}  // namespace touchstone::cli
