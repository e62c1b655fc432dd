// The rules about includes: the design's table of layers, applied to the text of a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::structure {

using Layers = std::set<std::string>;

/// The layers that each layer may use.
using LayerTable = std::map<std::string, Layers>;

/// The "may use" column of the design's table of layers.
const LayerTable& layer_table();

/// A wing of src/: the folder of layers that are shipped or linked together.
struct Wing {
  Layers holds;  ///< a layer with the wing's own name is the wing's folder itself
  Layers uses;   ///< the other wings that its layers may use
};

/// The design's table of wings.
const std::map<std::string, Wing>& wing_table();

/// Where the layers' permissions do not keep to those of their wings, or a layer is in no wing, or in two.
std::vector<std::string> wing_violations(const LayerTable& layers);

/// The layers that src/`path` uses, by its includes.
Layers layers_used_by(const std::string& path, std::string_view text);

/// The layer of src/`path` ("core/exact/decide.cpp": "exact"); empty for a file of none.
std::string layer_of(const std::string& path);

/// A cycle of layers that use each other, "a -> b -> a"; empty when the table has none.
std::string cycle_of(const LayerTable& table);

struct Include {
  int line = 0;
  std::string target;
  bool quoted = false;  ///< "target" rather than <target>
};

/// The #include lines of a source file, in order; not those in comments.
std::vector<Include> includes_of(std::string_view text);

/// The forbidden includes of src/`path` ("core/exact/decide.cpp"), one sentence each, with the line.
std::vector<std::string> source_violations(const std::string& path, std::string_view text);

/// The differences between wing_table() and layer_table() and the tables on a page of docs/ with the columns wing,
/// holds, may use, and folder, what lives there, may use.
std::vector<std::string> table_differences(std::string_view page);

/// The forbidden includes of include/touchstone/`name` ("solve.hpp").
std::vector<std::string> public_header_violations(const std::string& name, std::string_view text);

/// Whether a header's path belongs to CGAL, GMP, MPFR or Boost, which stay inside `numbers` and `oracle`.
bool is_number_library(std::string_view header);

/// The expression after "SPDX-License-Identifier:" in a file's first lines; empty when there is none.
std::string licence_of(std::string_view text);

/// Whether a licence expression names the GPL or the AGPL, or nothing at all. The LGPL is neither.
bool is_forbidden_licence(std::string_view expression);

}  // namespace touchstone::structure
