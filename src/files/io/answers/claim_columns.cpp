// SPDX-License-Identifier: MIT
#include "io/answers/claim_columns.hpp"

#include <algorithm>

#include <touchstone/error.hpp>

#include "io/characters.hpp"
#include "io/counted.hpp"
#include "io/fail.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::io {
namespace {

/// The names of each column, the one of answers.csv first; then empty ones.
constexpr std::array<std::array<std::string_view, 9>, kClaimColumns> kColumnNames = {{
    {"file", "filename"},
    {"query", "id", "index", "query_id", "query_index"},
    {"contact", "hit", "collision", "collides", "collided", "colliding", "is_colliding", "result"},
    {"toi", "time", "t", "time_of_impact", "toc", "time_of_contact"},
    {"toi_upper"},
    {"separation"},
    {"metric"},
}};

/// The other columns of answers.csv.
constexpr std::array<std::string_view, 6> kDescriptions = {"nature", "feature_a",     "feature_b",
                                                           "level",  "starts_within", "trend"};

}  // namespace

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

bool is_description(std::string_view name) {
  return std::find(kDescriptions.begin(), kDescriptions.end(), name) != kDescriptions.end();
}

std::optional<ClaimColumn> claim_column(std::string_view name) {
  std::string lower = in_lower_case(without_blanks(name));
  std::replace(lower.begin(), lower.end(), ' ', '_');
  std::replace(lower.begin(), lower.end(), '-', '_');
  for (std::size_t i = 0; i < kColumnNames.size() && !lower.empty(); ++i) {
    if (std::find(kColumnNames[i].begin(), kColumnNames[i].end(), lower) != kColumnNames[i].end())
      return static_cast<ClaimColumn>(i);
  }
  return std::nullopt;
}

std::string_view claim_column_name(ClaimColumn column) { return kColumnNames[static_cast<std::size_t>(column)][0]; }

std::string claim_column_names() {
  std::string text;
  for (const auto& names : kColumnNames) {
    text += (text.empty() ? "" : ", ") + std::string(names[0]);
    for (std::size_t i = 1; i < names.size() && !names[i].empty(); ++i) {
      text += (i == 1 ? " (or " : ", ") + std::string(names[i]);
    }
    if (!names[1].empty()) text += ")";
  }
  return text;
}

ClaimColumns parse_claim_columns(std::string_view text) {
  ClaimColumns columns;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view name = without_blanks(text.substr(at, end - at));
    const auto column = name == "-" ? ClaimColumn::unread : claim_column(name);
    if (!column) throw Error("unknown column " + in_quotes(name) + "; known are " + claim_column_names() + " and -");
    if (column != ClaimColumn::unread && std::count(columns.begin(), columns.end(), *column) != 0) {
      throw Error("the column " + in_quotes(name) + " says what one before it says");
    }
    columns.push_back(*column);
    at = end + 1;
  }
  const auto has = [&](ClaimColumn column) { return std::count(columns.begin(), columns.end(), column) != 0; };
  if (has(ClaimColumn::metric) && !has(ClaimColumn::separation)) throw Error("the column metric needs separation");
  return columns;
}

std::string fault_of_column_count(std::size_t count, const ClaimColumns& columns) {
  std::string text = counted(count, "column") + " where --columns names " + std::to_string(columns.size());
  if (columns.size() > count) return text;
  std::string names;
  for (std::size_t i = 0; i < count && i < columns.size() + 3; ++i) {
    const bool named = i < columns.size() && columns[i] != ClaimColumn::unread;
    if (i > 0) names += ',';
    names += named ? claim_column_name(columns[i]) : "-";
  }
  return text + "; a - names one that is not read, for example --columns " + names +
         (count > columns.size() + 3 ? ",..." : "");
}

std::string fault_without_contact(std::string_view thing, bool has_query, MissingClaim missing) {
  if (has_query && missing == MissingClaim::no_contact) return {};
  return "no " + std::string(thing) + " is a 'contact' or a 'toi'; known names are " + claim_column_names() +
         ". A list of contacts alone, each with the number of its query, needs none with --missing no-contact";
}

std::optional<double> parse_exact_double(std::string_view text) {
  const auto number = parse_finite_double(text);
  return number && numbers::is_exactly_a_double(text) ? number : std::nullopt;
}

std::optional<bool> contact_of_toi(std::string_view toi) {
  if (const auto time = parse_rounded_double(toi)) {
    return *time >= 0 && *time <= 1 ? std::optional(true) : std::nullopt;
  }
  std::string lower = in_lower_case(toi);
  if (lower.starts_with('+')) lower.erase(0, 1);
  for (const std::string_view none : {"", "inf", "infinity", "nan", "none", "null"}) {
    if (lower == none) return false;
  }
  return std::nullopt;
}

std::optional<bool> parse_truth(std::string_view text) {
  if (text == "0" || text == "1") return text == "1";
  if (const auto number = parse_exact_double(text)) {
    return *number == 0 || *number == 1 ? std::optional(*number == 1) : std::nullopt;
  }
  const std::string lower = in_lower_case(text);
  if (lower == "true" || lower == "yes") return true;
  if (lower == "false" || lower == "no") return false;
  return std::nullopt;
}

}  // namespace touchstone::io
