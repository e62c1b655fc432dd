// The bundled queries with the answers that their construction gives. The parser is strict and shares nothing with the
// program's reader.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/curved_query.hpp>
#include <touchstone/query.hpp>
#include <touchstone/separation.hpp>

#include "cli/queries/bundled.hpp"

namespace touchstone::tests {

/// One query of a bundled file, and the "# expect" line above it.
struct ExpectedQuery {
  std::string file;        ///< "bundled/KIND/FAMILY.csv"
  std::size_t number = 0;  ///< counted from 0 within the file
  RationalQuery query;     ///< for curved motion its kind alone
  std::optional<CurvedQuery> curved;
  Separation separation;  ///< of the line "# separation D METRIC" before the file's first query; else touching
  bool truth = false;
  std::map<std::string, std::string>
      expect;  ///< "contact", and maybe "toi", "toi_upper", "nature", "feature_a", "trend", ...

  /// File and number, and the command that shows how the program answers.
  std::string name() const;
};

/// @throws std::runtime_error  naming the file and line of the first fault
std::vector<ExpectedQuery> parse_bundled_file(const cli::BundledFile& file);

/// The queries of all bundled files.
const std::vector<ExpectedQuery>& expected_queries();

/// The query in doubles, when it has no other coordinates.
std::optional<Query> in_doubles(const RationalQuery& query);

}  // namespace touchstone::tests
