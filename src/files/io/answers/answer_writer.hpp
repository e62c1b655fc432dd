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

/// The text of such a field without its quotes: without the apostrophe of csv_field.
std::string_view text_of_field(std::string_view field) noexcept;

/// How doubles are written. Each reads back as the same double; a decimal is the shortest one that does.
enum class Numbers : std::uint8_t { hexfloats, decimals };

/// A finite double in that form.
std::string number_text(double value, Numbers form);

/// Appends one row. Without contact every column between `contact` and `level` is empty.
/// @param file_field  the file's name, already through csv_field
void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   Numbers numbers);

/// The same with the columns of kSeparationAnswerHeader. Without contact `starts_within` and `trend` are empty; without
/// a trend, as for separation 0, `trend` is.
void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer,
                   const Separation& separation, Numbers numbers);

/// The name of a file as a JSON string, with quotes; bytes that are no UTF-8 become U+FFFD.
std::string json_string(std::string_view text);

/// Appends one line of JSON with the names of the columns as keys, decimals, and null for what is empty in a row.
/// @param separation  null: the query was about touching, and the line has no columns of a separation
/// @param more        further members at the end, a comma before each
void append_answer_line(std::string& out, std::string_view file_string, std::uint64_t query, const Answer& answer,
                        const Separation* separation, std::string_view more = {});

}  // namespace touchstone::io
