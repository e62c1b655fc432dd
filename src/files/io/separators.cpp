// SPDX-License-Identifier: MIT
#include "io/separators.hpp"

#include <algorithm>

#include "io/characters.hpp"
#include "io/fail.hpp"

namespace touchstone::io {

char separator_of(std::string_view row) noexcept {
  if (row.ends_with('\r')) row.remove_suffix(1);
  constexpr std::string_view kSeparators = ";,\t ";
  std::size_t found = kSeparators.size();
  bool quoted = false;
  for (const char c : without_blanks(row)) {
    quoted = quoted != (c == '"');
    if (!quoted) found = std::min(found, kSeparators.find(c));
  }
  return found < kSeparators.size() ? kSeparators[found] : ',';
}

std::vector<std::string_view> fields_of(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> fields;
  for (std::size_t at = 0; at <= line.size();) {
    const std::size_t end = std::min(line.find(',', at), line.size());
    fields.push_back(without_blanks(line.substr(at, end - at)));
    at = end + 1;
  }
  return fields;
}

std::string put_commas(std::span<char> row, char separator) {
  const std::string_view text(row.data(), row.size());
  const std::string_view padding = padding_beside(separator);
  std::size_t last = text.ends_with('\r') ? text.size() - 1 : text.size();
  while (last > 0 && padding.find(text[last - 1]) != std::string_view::npos) --last;
  const auto skip_padding = [&](std::size_t at) { return std::min(text.find_first_not_of(padding, at), last); };
  std::size_t at = skip_padding(0);
  for (std::size_t column = 1;; ++column) {
    const auto fault = [&](const std::string& reason) { return "column " + std::to_string(column) + reason; };
    std::size_t end = std::min(text.find(separator, at), last);
    std::string_view field = text.substr(at, end - at);
    if (field.starts_with('"')) {
      const std::size_t quote = text.find('"', at + 1);
      if (quote >= last) return fault(" has a quote that is not closed");
      field = text.substr(at + 1, quote - at - 1);
      end = skip_padding(quote + 1);
      const bool ends = end == last || text[end] == separator || (separator == ' ' && end > quote + 1);
      if (!ends) return fault(" has text after a closing quote");
      if (separator == ' ' && end < last) end = quote + 1;
      row[at] = row[quote] = ' ';
    } else if (field.find('"') != std::string_view::npos) {
      return fault(" has a quote, and does not start with one");
    }
    if (field.find(',') != std::string_view::npos) {
      return fault(" is " + in_quotes(field) + "; a number has a point, such as 0.5, and no comma");
    }
    if (end == last) return {};
    row[end] = ',';
    at = skip_padding(end + 1);
  }
}

}  // namespace touchstone::io
