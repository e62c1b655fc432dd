// SPDX-License-Identifier: MIT
#include "cli/certify/json_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <touchstone/error.hpp>

#include "io/answers/claim_columns.hpp"
#include "io/fail.hpp"

namespace touchstone::cli {
namespace {

/// The cells of a column with the numbers of their rows, in ascending order.
using Cells = std::vector<std::pair<std::uint64_t, nlohmann::json*>>;

std::uint64_t row_number(const std::string& column, const std::string& name) {
  constexpr std::size_t kMostDigits = 15;
  const bool is_number =
      !name.empty() && name.size() <= kMostDigits && name.find_first_not_of("0123456789") == std::string::npos;
  if (is_number) return std::stoull(name);
  throw Error(fmt::format("{} has a row {}; the names of rows must be their numbers", io::shortened(column),
                          io::in_quotes(name)));
}

Cells cells_of(const std::string& name, nlohmann::json& column) {
  Cells cells;
  cells.reserve(column.size());
  if (column.is_array()) {
    for (nlohmann::json& cell : column) cells.emplace_back(cells.size(), &cell);
  } else {
    for (const auto& [row, cell] : column.items()) cells.emplace_back(row_number(name, row), &cell);
    std::sort(cells.begin(), cells.end());
  }
  return cells;
}

bool have_same_rows(const Cells& a, const Cells& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& one, const auto& other) { return one.first == other.first; });
}

bool counts_from_zero(const Cells& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].first != i) return false;
  }
  return true;
}

}  // namespace

json::JsonDocument as_records(json::JsonDocument document) {
  nlohmann::json& table = document.value();
  if (!table.is_object()) return document;
  nlohmann::json records = nlohmann::json::array();
  const auto is_columns = [&] {
    for (const auto& [key, value] : table.items()) {
      if (value.is_structured() && io::claim_column(key)) return true;
    }
    return false;
  };
  if (!is_columns()) {
    records.push_back(std::move(table));
  } else {
    std::string first_name;
    Cells first;
    bool has_numbers = false;
    for (auto& [name, column] : table.items()) {
      if (!io::claim_column(name)) continue;
      if (!column.is_structured()) {
        throw Error(io::shortened(name) + " is one value beside columns; all columns have the same rows");
      }
      const Cells cells = cells_of(name, column);
      if (first_name.empty()) {
        first_name = name;
        first = cells;
        records.get_ref<nlohmann::json::array_t&>().resize(cells.size(), nlohmann::json::object());
      } else if (!have_same_rows(first, cells)) {
        throw Error(fmt::format("{} has {} rows, and {} has {}; all columns have the same rows",
                                io::shortened(first_name), first.size(), io::shortened(name), cells.size()));
      }
      has_numbers = has_numbers || io::claim_column(name) == io::ClaimColumn::query;
      for (std::size_t row = 0; row < cells.size(); ++row) records[row][name] = std::move(*cells[row].second);
    }
    for (const auto& [name, ignored] : table.items()) {  // the first row tells what is not read
      if (!io::claim_column(name) && !records.empty()) records[0][name] = nullptr;
    }
    for (std::size_t row = 0; !has_numbers && !counts_from_zero(first) && row < first.size(); ++row) {
      records[row]["query"] = first[row].first;
    }
  }
  json::JsonDocument result;
  result.value() = std::move(records);
  return result;
}

}  // namespace touchstone::cli
