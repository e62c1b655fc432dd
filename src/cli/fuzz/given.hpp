// The queries that `touchstone fuzz --from` starts from.
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <touchstone/query.hpp>

#include "cli/fuzz/fuzz.hpp"

namespace touchstone::cli {

/// Every query of the files of `--from` whose coordinates are doubles. How many are left out, and where the first of
/// them stands, is said on standard error, file by file.
/// A file is of the kind that its folder is named after, or else of the one that `--kind` or `--case` names.
/// @throws Error  when none is left
std::vector<Query> given_queries(const FuzzOptions& options);

/// Nothing that is read by `--from` may be one of the files that `--out` is for. @throws FileError
void refuse_to_overwrite_given(const FuzzOptions& options);

}  // namespace touchstone::cli
