// The queries that `touchstone fuzz --from` starts from.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/query.hpp>

#include "cli/shared/findings/search_options.hpp"

namespace touchstone::cli {

/// Every query of the files of `--from` whose coordinates are doubles, straight or curved. Standard error says, file by
/// file, how many queries are left out and which is the first of them.
/// A file is of the kind that its folder is named after, or else of the one that `--kind` or `--case` names.
/// @throws Error  when none is left
std::vector<fuzz::AnyQuery> given_queries(const FuzzCommandOptions& options);

/// Checks that no file of `--from` is one that `--out` would write. @throws FileError
void refuse_to_overwrite_given(const FuzzCommandOptions& options);

}  // namespace touchstone::cli
