// Which file may include what: the layer table of the design as a function of a file's text.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace touchstone::structure {

struct Include {
  int line = 0;
  std::string target;
  bool quoted = false;  ///< "target" rather than <target>
};

/// The #include lines of a source file, in order; not those in comments.
std::vector<Include> includes_of(std::string_view text);

/// The forbidden includes of src/`path` ("exact/decide.cpp"), one sentence each, with the line.
std::vector<std::string> source_violations(const std::string& path, std::string_view text);

/// The differences between the table of layers on a page of docs/ (folder, what lives there, may use) and the one that
/// is held here.
std::vector<std::string> layer_table_differences(std::string_view page);

/// The forbidden includes of include/touchstone/`name` ("solve.hpp").
std::vector<std::string> public_header_violations(const std::string& name, std::string_view text);

/// Whether a header's path belongs to CGAL, GMP, MPFR or Boost, which stay inside `numbers` and `oracle`.
bool is_number_library(std::string_view header);

/// The expression after "SPDX-License-Identifier:" in a file's first lines; empty when there is none.
std::string licence_of(std::string_view text);

/// Whether a licence expression names the GPL or the AGPL, or nothing at all. The LGPL is neither.
bool is_forbidden_licence(std::string_view expression);

}  // namespace touchstone::structure
