// Rows of answers.csv.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>
#include <touchstone/separation.hpp>

namespace touchstone::io {

/// The header, with its line end.
inline constexpr std::string_view kAnswerHeader = "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level\n";

/// The header with a separation: the same columns, and then what only a separation needs. The last two columns repeat
/// the separation in each row, so that the file says what its answers are about.
inline constexpr std::string_view kSeparationAnswerHeader =
    "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level,starts_within,trend,separation,metric\n";

/// Whether a spreadsheet may run the text: after any number of apostrophes it begins with = + - @, a tab or a carriage
/// return. With an apostrophe more it still does, so that readers can take away the one of csv_field.
bool begins_formula(std::string_view text) noexcept;

/// `text` as a CSV field by RFC 4180. If it contains a comma, a quote or a line end, it is in quotes and its quotes are
/// doubled. A spreadsheet runs a text such as =1+1 as a formula, so texts of begins_formula have an apostrophe before
/// them, also in quotes.
std::string csv_field(std::string_view text);

/// Appends one row. Without contact every column between `contact` and `level` is empty.
/// @param file_field  the file's name, already through csv_field
void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer);

/// The same with the columns of kSeparationAnswerHeader. Without contact `starts_within` and `trend` are empty; without
/// a trend, as for separation 0, `trend` is.
void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   const Separation& separation);

}  // namespace touchstone::io
