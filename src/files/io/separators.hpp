// What stands between the fields of a row of text: commas, or what spreadsheets and other programs put there.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace touchstone::io {

/// The separator of a table with this first row: outside quotes it has semicolons, or else commas, or else tabs, or
/// else blanks within. A comma where it has none of them.
char separator_of(std::string_view row) noexcept;

/// What may stand around a field beside its separator. A tab that separates is no padding: two of them have an empty
/// field between them. Blanks that separate are one separator, however many they are.
constexpr std::string_view padding_beside(char separator) noexcept { return separator == '\t' ? " " : " \t"; }

/// What stands between the commas of a row, without blanks around it.
std::vector<std::string_view> fields_of(std::string_view row);

/// Puts commas in place of a row's separators, and blanks in place of the quotes around fields. So the row of numbers
/// keeps its length.
/// @returns why not: quotes that are not closed, say, or a field that has a comma in it; or an empty text
std::string put_commas(std::span<char> row, char separator);

}  // namespace touchstone::io
