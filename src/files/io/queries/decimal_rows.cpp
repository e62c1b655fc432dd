// SPDX-License-Identifier: MIT
#include "io/queries/decimal_rows.hpp"

#include <algorithm>
#include <cmath>

#include "io/answers/claim_columns.hpp"
#include "io/characters.hpp"
#include "io/fail.hpp"
#include "io/queries/query_writer.hpp"
#include "io/separators.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::io {
namespace {

std::size_t numbers_per_row(Kind kind, RowFormat format) {
  return format == RowFormat::whole_query ? 6 * corner_count(kind) : 3;
}

std::string columns_text(std::size_t count) { return std::to_string(count) + (count == 1 ? " column" : " columns"); }

/// "x of v at t = 1".
std::string name_of_number(Kind kind, RowFormat format, std::size_t i) {
  const std::string axis(1, "xyz"[i % 3]);
  if (format == RowFormat::corners) return axis;
  const std::size_t corner = i / 3, corners = corner_count(kind);
  return axis + " of " + std::string(corner_name(kind, corner % corners)) + " at t = " + (corner < corners ? "0" : "1");
}

}  // namespace

std::optional<RowFormat> format_of_row(std::string_view row, Kind kind) {
  const std::size_t columns = fields_of(row).size();
  const std::size_t whole = numbers_per_row(kind, RowFormat::whole_query);
  if (columns == 6 || columns == 7) return RowFormat::fractions;
  if (columns == 3 || columns == 4) return RowFormat::corners;
  if (columns == whole || columns == whole + 1) return RowFormat::whole_query;
  return std::nullopt;
}

bool names_columns(std::string_view row) {
  const auto is_word = [](std::string_view text) {
    const std::string lower = in_lower_case(text);
    const bool is_letter = !lower.empty() && ((lower[0] >= 'a' && lower[0] <= 'z') || lower[0] == '_');
    for (const char* const number : {"nan", "inf", "infinity", "none", "null", "na"}) {
      if (lower == number) return false;
    }
    return is_letter;
  };
  const auto fields = fields_of(row);
  return std::all_of(fields.begin(), fields.end(), is_word);
}

bool counts_from_zero(std::string_view row) {
  const auto fields = fields_of(row);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != std::to_string(i)) return false;
  }
  return true;
}

namespace {

/// The axis that a name of a column stands for, by the first letter in which the names of three columns differ: of vx,
/// vy and vz, or of x, y and z. Nothing where that is none of x, y and z.
std::optional<std::size_t> axis_of(const std::vector<std::string_view>& names, std::size_t column) {
  std::size_t same = 0;
  const auto differ = [&](std::size_t at) {
    for (std::size_t i = 1; i < std::min<std::size_t>(names.size(), 3); ++i) {
      if (at >= names[i].size() || at >= names[0].size() || names[i][at] != names[0][at]) return true;
    }
    return false;
  };
  while (!differ(same)) ++same;
  const std::string word = in_lower_case(names[column]);
  const std::size_t axis = same < word.size() ? std::string_view("xyz").find(word[same]) : std::string_view::npos;
  return axis == std::string_view::npos ? std::nullopt : std::optional(axis);
}

}  // namespace

std::string fault_of_names(std::string_view names, std::string_view row, Kind kind) {
  const auto words = fields_of(names);
  const std::size_t columns = fields_of(row).size();
  if (words.size() != columns) {
    return "the line names " + columns_text(words.size()) + ", and the first row has " + std::to_string(columns);
  }
  const RowFormat format = format_of_row(row, kind).value_or(RowFormat::fractions);
  const bool truth_is_last = format == RowFormat::fractions ? columns == 7 : has_truth(row, kind, format);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = in_lower_case(words[i]);
    const bool is_truth = word == "truth" || claim_column(word) == ClaimColumn::contact;
    if (is_truth != (truth_is_last && i + 1 == words.size())) {
      return "column " + std::to_string(i + 1) + " is called " + in_quotes(words[i]) +
             (is_truth ? "; the truth stands last, behind the coordinates"
                       : "; the last of so many columns is truth, 0 or 1: only coordinates stand before it");
    }
    if (format == RowFormat::corners && !is_truth && (claim_column(word) || axis_of(words, i).value_or(i) != i)) {
      return "column " + std::to_string(i + 1) + " is called " + in_quotes(words[i]) + "; the columns are x, y and z";
    }
  }
  return {};
}

bool has_truth(std::string_view row, Kind kind, RowFormat format) {
  return fields_of(row).size() == numbers_per_row(kind, format) + 1;
}

std::size_t rows_per_query(Kind kind, RowFormat format) noexcept {
  return format == RowFormat::whole_query ? 1 : 2 * corner_count(kind);
}

std::string fault_of_columns(std::string_view row, Kind kind) {
  return columns_text(fields_of(row).size()) + "; " + right_rows(kind);
}

std::string right_rows(Kind kind) {
  const std::size_t whole = numbers_per_row(kind, RowFormat::whole_query);
  return "a row is a corner as fractions, with 7 columns: x_num,x_den,y_num,y_den,z_num,z_den,truth, or 6 without "
         "truth; a "
         "corner as decimals, x,y,z with 3, or 4 with truth; or a whole " +
         std::string(name_of(kind)) + " query, with " + std::to_string(whole) + " decimals, and truth or not";
}

std::string read_decimals(std::string_view line, Kind kind, RowFormat format, bool has_truth, Decimals decimals,
                          std::vector<Fraction>& numbers, std::optional<bool>& truth) {
  if (line.find('\0') != std::string_view::npos) return "a zero byte; this is no text file";
  const auto fields = fields_of(line);
  const std::size_t count = numbers_per_row(kind, format);
  if (fields.size() != count + (has_truth ? 1 : 0)) {
    return columns_text(fields.size()) + "; the first row has " + std::to_string(count) + " decimals" +
           (format == RowFormat::corners ? ", x,y,z" : "") + (has_truth ? " and truth" : " and no truth");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view field = fields[i];
    const auto fault = [&](const std::string& reason) {
      return name_of_number(kind, format, i) + " is " + in_quotes(field) + "; " + reason;
    };
    std::string_view plain = field;
    if (plain.starts_with('+')) plain.remove_prefix(1);
    const bool has_two_signs = plain.size() < field.size() && plain.starts_with('-');
    const auto nearest = has_two_signs ? std::nullopt : parse_rounded_double(plain);
    if (!nearest) return fault("it must be a number such as -0.25, 1e-3 or 0x1p-2");
    if (decimals == Decimals::nearest_double) {
      if (std::isinf(*nearest)) return fault("it is beyond the greatest double");
      numbers.push_back(fraction_of(*nearest));
      continue;
    }
    auto exactly = numbers::exact_value(plain);
    if (!exactly) {
      return fault("as a fraction it has more than " + std::to_string(numbers::kMostWrittenDigits) + " digits");
    }
    numbers.push_back({std::move(exactly->numerator), std::move(exactly->denominator)});
  }
  truth = std::nullopt;
  if (fields.size() == count) return {};
  truth = parse_truth(fields[count]);
  return truth ? std::string() : "truth is " + in_quotes(fields[count]) + "; " + std::string(kTruthIsRight);
}

}  // namespace touchstone::io
