// The query files that are built into the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace touchstone::cli {

struct BundledFile {
  std::string_view name;     ///< "bundled/KIND/FAMILY.csv"
  std::string_view content;  ///< the file as it stands in src/cli/queries, with '\n' line ends
};

/// All of them, by name.
const std::vector<BundledFile>& bundled_files();

}  // namespace touchstone::cli
