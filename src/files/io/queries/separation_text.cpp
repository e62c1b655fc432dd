// SPDX-License-Identifier: MIT
#include "io/queries/separation_text.hpp"

#include <algorithm>

#include "io/queries/curved_rows.hpp"
#include "io/queries/query_chunks.hpp"
#include "io/times.hpp"

namespace touchstone::io {
namespace {

constexpr std::string_view kComment = "# separation ";

/// The rest of a line after kComment: "0x1p-3 euclidean". Any other comment may start with the same word.
std::optional<Separation> read_separation(std::string_view rest) {
  const std::size_t blank = std::min(rest.find(' '), rest.size());
  const auto distance = parse_finite_double(rest.substr(0, blank));
  const auto metric = from_name<Metric>(rest.substr(std::min(blank + 1, rest.size())));
  if (!distance || *distance < 0 || !metric) return std::nullopt;
  return Separation{*distance, *metric};
}

}  // namespace

bool same_question(const Separation& a, const Separation& b) noexcept {
  return a.distance == b.distance && (a.distance == 0 || a.metric == b.metric);
}

std::string separation_comment(const Separation& separation) {
  return std::string(kComment) + hexfloat(separation.distance) + " " + std::string(name_of(separation.metric)) + "\n";
}

std::optional<Separation> separation_of_comments(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (is_row(line) && !announces_curved_queries(line) && !names_columns(line)) return std::nullopt;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.starts_with(kComment)) {
      if (const auto separation = read_separation(line.substr(kComment.size()))) return separation;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return std::nullopt;
}

}  // namespace touchstone::io
