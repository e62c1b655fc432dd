// The columns of a table of claims, by the names that solvers give them, and how their fields say yes or no.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::io {

/// What a column of a table of claims says.
enum class ClaimColumn : std::size_t { file, query, contact, toi, toi_upper, separation, metric, unread };

/// The number of columns that are read.
inline constexpr std::size_t kClaimColumns = static_cast<std::size_t>(ClaimColumn::unread);

/// What each column of a table says, in order.
using ClaimColumns = std::vector<ClaimColumn>;

/// The column of a name in any case: "query", "id" and so on. Nothing for any other name.
std::optional<ClaimColumn> claim_column(std::string_view name);

/// Whether a column of this name describes a contact in answers.csv, and claims nothing: "nature", "level" and so on.
bool is_description(std::string_view name);

/// The first name of a column: "query".
std::string_view claim_column_name(ClaimColumn column);

/// "query (or id, index, ...), contact (or hit, ...)": all names, for messages.
std::string claim_column_names();

/// Reads "id,hit,-,toi": names as above, and - for a column that is not read.
/// @throws Error  for any other name, a name that is there twice, and without a column of contact
ClaimColumns parse_claim_columns(std::string_view text);

/// Why `count` columns are not those that --columns names, for messages: "4 columns where --columns names 2: ...".
std::string fault_of_column_count(std::size_t count, const ClaimColumns& columns);

/// In lower case: ASCII alone.
std::string in_lower_case(std::string_view text);

/// What is right where parse_truth() reads nothing, for messages.
inline constexpr std::string_view kTruthIsRight = "it must be 0 or 1, true or false, or yes or no";

/// Yes or no as solvers write it: 0 or 1, in any spelling of these numbers; true or false, yes or no, in any case.
std::optional<bool> parse_truth(std::string_view text);

}  // namespace touchstone::io
