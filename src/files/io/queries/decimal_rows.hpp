// Query files of decimals: a row x,y,z for each corner, or one row with all numbers of a query.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <touchstone/query.hpp>

namespace touchstone::io {

/// What the rows of a query file of text hold, as its first row tells.
enum class RowFormat : std::uint8_t {
  fractions,   ///< x_num,x_den,y_num,y_den,z_num,z_den and, or not, truth: a corner
  corners,     ///< x,y,z and, or not, truth: a corner as decimals
  whole_query  ///< x,y,z of all corners at t = 0, then at t = 1, and, or not, truth
};

/// What a decimal stands for that is no double.
enum class Decimals : std::uint8_t {
  exact,          ///< the number that is written
  nearest_double  ///< the nearest double
};

/// The format of a file with this first row; nothing where there is none with so many columns.
std::optional<RowFormat> format_of_row(std::string_view row, Kind kind);

/// Whether a row names columns: each of its fields is a word.
bool names_columns(std::string_view row);

/// Whether the fields of a row are the numbers 0, 1, 2 and so on.
bool counts_from_zero(std::string_view row);

/// Why the names of a line before the first row contradict that row, or an empty text. As many names as columns, x, y
/// and z in their order, and a truth, and no number of the query, in the last column that the format has room for.
std::string fault_of_names(std::string_view names, std::string_view row, Kind kind);

/// The rows of a query.
std::size_t rows_per_query(Kind kind, RowFormat format) noexcept;

/// "5 columns; a row of an edge-edge query has ...": what is right for a row that no format has.
std::string fault_of_columns(std::string_view row, Kind kind);

/// What is right: the rows of each format.
std::string right_rows(Kind kind);

/// Appends the numbers of a row as fractions, and reads its truth.
/// @param line       without '\n'
/// @param has_truth  whether the file's first row has one
/// @returns why the row is wrong, or an empty text
std::string read_decimals(std::string_view line, Kind kind, RowFormat format, bool has_truth, Decimals decimals,
                          std::vector<Fraction>& numbers, std::optional<bool>& truth);

/// Whether a row of decimals has a truth.
bool has_truth(std::string_view row, Kind kind, RowFormat format);

}  // namespace touchstone::io
