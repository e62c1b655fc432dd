// Rows of answers.csv.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <touchstone/answer.hpp>

namespace touchstone::io {

/// The header, with its line end.
inline constexpr std::string_view kAnswerHeader = "file,query,contact,toi,toi_upper,nature,feature_a,feature_b,level\n";

/// `text` as a CSV field by RFC 4180. If it contains a comma, a quote or a line end, it is in quotes and its quotes are
/// doubled.
std::string csv_field(std::string_view text);

/// Appends one row. Without contact every column between `contact` and `level` is empty.
/// @param file_field  the file's name, already through csv_field
void append_answer(std::string& out, std::string_view file_field, std::uint64_t query, const Answer& answer);

}  // namespace touchstone::io
