// SPDX-License-Identifier: MIT
#include "pipes/protocol.hpp"

#include <cmath>
#include <limits>

#include "io/queries/kind_of_file.hpp"
#include "io/times.hpp"
#include "numbers/written_number.hpp"

namespace touchstone::pipes {
namespace {

constexpr std::size_t kLongestNumber = 1024;
constexpr std::string_view kBlanks = " \t";

std::string_view without_blanks(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}

bool equal_but_case(std::string_view text, std::string_view lower) noexcept {
  if (text.size() != lower.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i] >= 'A' && text[i] <= 'Z' ? static_cast<char>(text[i] - 'A' + 'a') : text[i];
    if (c != lower[i]) return false;
  }
  return true;
}

/// Any number that strtod reads in the C locale, rounded also beyond the doubles' range.
std::optional<double> parse_any_double(std::string_view text) noexcept {
  if (text.size() > kLongestNumber) return std::nullopt;
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::optional<double> value;
  if (equal_but_case(text, "inf") || equal_but_case(text, "infinity")) {
    value = std::numeric_limits<double>::infinity();
  } else if (equal_but_case(text, "nan")) {
    value = std::numeric_limits<double>::quiet_NaN();
  } else if (!text.starts_with('-')) {
    value = io::parse_rounded_double(text);
  }
  if (value && negative) value = -*value;
  return value;
}

/// The text of a finite time that is no double, for the judge; empty for the others.
std::string text_beside_doubles(std::string_view number, double nearest) {
  if (!std::isfinite(nearest) || io::is_plainly_a_double(number)) return {};
  std::string text(number.substr(number.starts_with('+') ? 1 : 0));
  if (numbers::exact_value(text)) return numbers::is_exactly_a_double(text) ? std::string() : text;
  // This number has more digits than are read exactly. kLongestNumber characters cannot spell so many digits without an
  // exponent far below 0. So the number is closer to 0 than any contact time of a query of doubles, except the time 0.
  // All these times compare with 1e-4000 as they do with the number. They are roots of polynomials whose nonzero
  // coefficients lie between 2^-3222 and 2^3100. So no time except 0 is below 2^-6400, about 1e-1927.
  return text.starts_with('-') ? "-1e-4000" : "1e-4000";
}

/// The first word of `text`, which is left with the rest.
std::string_view take_word(std::string_view& text) noexcept {
  text = without_blanks(text);
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

void append(std::string& line, const Vec3& corner) {
  for (const double x : {corner.x, corner.y, corner.z}) (line += ' ') += io::hexfloat(x);
}

bool take_corner(std::string_view& text, Vec3& corner) noexcept {
  for (double* const x : {&corner.x, &corner.y, &corner.z}) {
    const auto value = io::parse_finite_double(take_word(text));
    if (!value) return false;
    *x = *value;
  }
  return true;
}

}  // namespace

std::string query_line(const Query& query) {
  std::string line(name_of(query.kind));
  line.reserve(640);
  for (const auto* corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) append(line, (*corners)[i]);
  }
  line += '\n';
  return line;
}

std::string separation_line(const Separation& separation) {
  return "separation " + io::hexfloat(separation.distance) + " " + std::string(name_of(separation.metric)) + "\n";
}

bool takes_separation(std::string_view answer) noexcept {
  if (answer.ends_with('\r')) answer.remove_suffix(1);
  return without_blanks(answer) == "ok";
}

std::optional<AnswerLine> read_answer_line(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  const std::string_view word = take_word(line);
  const std::string_view rest = without_blanks(line);
  AnswerLine answer;
  if (word == "unsupported") answer.supported = false;
  if (word == "unknown") answer.known = false;
  if (word == "1") answer.contact = true;
  if (!answer.contact && answer.supported && answer.known && word != "0") return std::nullopt;
  if (rest.empty()) return answer;
  if (!answer.contact) return std::nullopt;
  answer.toi = parse_any_double(rest);
  if (!answer.toi) return std::nullopt;
  answer.toi_as_written = text_beside_doubles(rest, *answer.toi);
  return answer;
}

std::optional<Query> read_query_line(std::string_view line) noexcept {
  const auto kind = from_name<Kind>(take_word(line));
  if (!kind) return std::nullopt;
  Query query;
  query.kind = *kind;
  for (auto* corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(*kind); ++i) {
      if (!take_corner(line, (*corners)[i])) return std::nullopt;
    }
  }
  if (!without_blanks(line).empty()) return std::nullopt;
  return query;
}

}  // namespace touchstone::pipes
