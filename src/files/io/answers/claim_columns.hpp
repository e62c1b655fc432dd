// The columns of a table of claims, by the names that solvers give them, and how their fields say yes or no.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

/// What a query is that has no claim in a file whose claims have the numbers of their queries.
enum class MissingClaim : std::uint8_t { refused, no_contact };

/// The column of a name in any case: "query", "id" and so on. Nothing for any other name.
std::optional<ClaimColumn> claim_column(std::string_view name);

/// Whether a column of this name describes a contact in answers.csv, and claims nothing: "nature", "level" and so on.
bool is_description(std::string_view name);

/// The first name of a column: "query".
std::string_view claim_column_name(ClaimColumn column);

/// "query (or id, index, ...), contact (or hit, ...)": all names, for messages.
std::string claim_column_names();

/// Reads "id,hit,-,toi": names as above, and - for a column that is not read.
/// @throws Error  for any other name, and a name that is there twice
ClaimColumns parse_claim_columns(std::string_view text);

/// Why `count` columns are not those that --columns names, for messages: "4 columns where --columns names 2: ...".
std::string fault_of_column_count(std::size_t count, const ClaimColumns& columns);

/// Why a table without a column `contact` has no claims. Empty where it may lack one: with MissingClaim::no_contact
/// each row with the number of a query is a contact.
/// @param thing  what a column is: "column", "key", "array"
std::string fault_without_contact(std::string_view thing, bool has_query, MissingClaim missing);

/// In lower case: ASCII alone.
std::string in_lower_case(std::string_view text);

/// What is right where parse_truth() reads nothing, for messages.
inline constexpr std::string_view kTruthIsRight = "it must be 0 or 1, true or false, or yes or no";

/// The double that `text` spells exactly: not 1 for 0.99999999999999999999. Nothing for other text.
std::optional<double> parse_exact_double(std::string_view text);

/// Whether a claim without a `contact` is one of contact, by its toi: a number of [0, 1] says so, and "inf", "nan",
/// "none", "null" and an empty text that there is none. Nothing for any other text.
std::optional<bool> contact_of_toi(std::string_view toi);

/// What is right where contact_of_toi() says nothing, for messages.
inline constexpr std::string_view kToiIsRight =
    "where nothing says whether there is contact, it must be in [0, 1], or inf, nan, none or empty for no contact";

/// Yes or no as solvers write it: 0 or 1, in any spelling of exactly these numbers; true or false, yes or no, in any
/// case.
std::optional<bool> parse_truth(std::string_view text);

}  // namespace touchstone::io
