// One row of a query file: x_num,x_den,y_num,y_den,z_num,z_den and, where the file has it, truth.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// More digits than this in one integer are refused. The longest denominator that a double needs, 2^1074, has 324.
inline constexpr std::size_t kMostDigits = 4096;

/// A row whose coordinates are doubles.
struct DoubleRow {
  Vec3 corner;
  std::optional<bool> truth;  ///< nothing in a row of six columns
};

/// Reads the row at `text` if it has the usual form: no blanks, coordinates that are doubles, numerators of at most
/// 2^53 in lowest terms and denominators of at most 38 digits. @returns the start of the next line, or nullptr when the
/// row has another form or is damaged. Eight bytes past the end of the line must be readable, and the last line must be
/// followed by a zero byte.
const char* read_usual_row(const char* text, DoubleRow& row) noexcept;

/// Any well-formed row, as text.
struct RowFields {
  std::array<Fraction, 3> corner;
  std::optional<bool> truth;  ///< nothing in a row of six columns
};

/// Splits a line (with or without its '\r') into its columns, and checks all of it: six columns or seven, decimal
/// integers with an optional '-' and blanks around them, positive denominators, a truth that parse_truth() reads. A
/// sign on a denominator, a leading '+', decimal points and exponents are refused, because they belong to other
/// formats.
/// @returns nothing when the line is not such a row; `reason` then says why
std::optional<RowFields> read_row(std::string_view line, std::string& reason);

}  // namespace touchstone::io
