// Tables in JSON, in the shapes that programs write.
// SPDX-License-Identifier: MIT
#pragma once

#include "json/json_node.hpp"

namespace touchstone::cli {

/// A list of rows, each an object, as it is; and one of
/// - columns, {"hit": [true, false], "toi": [0.5, null]}: of other keys than those of claim_columns.hpp the name alone
///   is kept, in the first row;
/// - columns as pandas writes them, {"hit": {"0": true, "1": false}, ...}: in the order of the rows' numbers. They are
///   the numbers of the queries if they are other numbers than 0, 1, 2, ... and no column has these;
/// - one row, {"hit": true}.
/// @throws Error  for columns of different rows, and for rows that have names but no numbers
json::JsonDocument as_records(json::JsonDocument document);

}  // namespace touchstone::cli
