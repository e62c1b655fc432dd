// SPDX-License-Identifier: MIT
#include "pipes/protocol.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "io/kind_of_file.hpp"
#include "io/times.hpp"

namespace touchstone::pipes {
namespace {

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

/// The rounded value of a well-formed number beyond the doubles' range, 0 or infinity. The position of its first digit
/// that is not 0 decides, because it lies hundreds of digits before or after the point.
double rounded_beyond_range(std::string_view text, bool hexadecimal) noexcept {
  const std::size_t mark = std::min(text.find_first_of(hexadecimal ? "pP" : "eE"), text.size());
  const std::string_view digits = text.substr(0, mark);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_not_of("0.");
  if (first == std::string_view::npos) return 0;
  const double place = static_cast<double>(point) - static_cast<double>(first);
  double exponent = 0;
  bool negative = false;
  for (const char c : text.substr(std::min(mark + 1, text.size()))) {
    if (c == '-') negative = true;
    if (c >= '0' && c <= '9') exponent = std::min(10 * exponent + (c - '0'), 1e15);
  }
  const double order = (hexadecimal ? 4 : 1) * place + (negative ? -exponent : exponent);
  return order > 0 ? std::numeric_limits<double>::infinity() : 0;
}

/// Any number that strtod reads in the C locale, rounded also beyond the doubles' range.
std::optional<double> parse_any_double(std::string_view text) noexcept {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  const auto signed_value = [&](double value) { return negative ? -value : value; };
  if (equal_but_case(text, "inf") || equal_but_case(text, "infinity")) {
    return signed_value(std::numeric_limits<double>::infinity());
  }
  if (equal_but_case(text, "nan")) return signed_value(std::numeric_limits<double>::quiet_NaN());

  const bool hexadecimal = text.starts_with("0x") || text.starts_with("0X");
  if (hexadecimal) text.remove_prefix(2);
  constexpr std::string_view kFirst = ".0123456789abcdefABCDEF";  // from_chars takes a sign and names of its own
  if (text.empty() || kFirst.substr(0, hexadecimal ? kFirst.size() : 11).find(text.front()) == std::string_view::npos) {
    return std::nullopt;
  }
  if (text.find("+-") != std::string_view::npos) return std::nullopt;  // libstdc++ 12 takes it for an exponent's sign
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] =
      std::from_chars(text.data(), last, value, hexadecimal ? std::chars_format::hex : std::chars_format::general);
  if (end != last) return std::nullopt;
  if (error == std::errc::result_out_of_range) return signed_value(rounded_beyond_range(text, hexadecimal));
  if (error != std::errc{}) return std::nullopt;
  return signed_value(value);
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
  std::string line(kind_name(query.kind));
  line.reserve(640);
  for (const auto* corners : {&query.start, &query.end}) {
    for (std::size_t i = 0; i < corner_count(query.kind); ++i) append(line, (*corners)[i]);
  }
  line += '\n';
  return line;
}

std::optional<AnswerLine> read_answer_line(std::string_view line) noexcept {
  if (line.ends_with('\r')) line.remove_suffix(1);
  const std::string_view word = take_word(line);
  const std::string_view rest = without_blanks(line);
  AnswerLine answer;
  if (word == "unsupported") answer.supported = false;
  if (word == "1") answer.contact = true;
  if (!answer.contact && answer.supported && word != "0") return std::nullopt;
  if (rest.empty()) return answer;
  if (!answer.contact) return std::nullopt;
  answer.toi = parse_any_double(rest);
  if (!answer.toi) return std::nullopt;
  return answer;
}

std::optional<Query> read_query_line(std::string_view line) noexcept {
  const auto kind = io::kind_from_name(take_word(line));
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
